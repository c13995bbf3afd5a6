// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// ocp_json: problems and solutions as JSON, for tests, benchmarks and bug reports.
//
// In memory only: whoever calls owns the files. Numbers survive a round trip bit for bit.
// Layout (units in the keys, one row of three numbers a knot or vertex): a problem has name,
// description, step_s, knots, mass_kg, gravity_m_s2, initial, reference, weights,
// external_force_N, external_torque_Nm, friction_A, friction_b, contacts, and may carry
// first_step_s, how long the first input lasts (step_s without it), foot_load_limit_N, without
// which weights.foot_load is zero, its solution under `solution`, and under `solver` how it was
// solved (solver_setup.h). tests/data/reference holds examples.

#include <nlohmann/json.hpp>
#include <string>

#include "controller/mpc/problem/centroidal_ocp.h"
#include "controller/mpc/problem/mpc_solution.h"

namespace sidestep::mpc {

/// The problem as JSON. Throws ContractViolation if CheckShapes() does. A number that is not
/// finite has no JSON form: its text is null, which OcpFromJson refuses.
nlohmann::json ToJson(const CentroidalOcp& ocp);

/// Reads a problem; blocks `solution` and `solver` are ignored. Throws ConfigError, one line with
/// the JSON path and what was expected, on a missing or unknown key, a wrong type or length, a
/// number that is not finite or out of range, shares that do not sum to 1, or phases out of order.
/// Optional: first_step_s, foot_load_limit_N (but with weights.foot_load above zero),
/// weights.foot_load, weights.leg_length, weights.new_contact_force, contacts[].previous_force_N,
/// contacts[].force_shares and contacts[].leg.
CentroidalOcp OcpFromJson(const nlohmann::json& json);

/// The solution block. A status without trajectories (infeasible, numerical error, not solved)
/// has its numbers null; forces are null where the contact is inactive. Throws ContractViolation
/// if the shapes differ from the problem's.
nlohmann::json SolutionToJson(const CentroidalOcp& ocp, const MpcSolution& solution);

/// The trajectories, landing places and forces alone: a solution block without its figures.
/// Throws ContractViolation if the shapes differ from the problem's.
nlohmann::json TrajectoriesToJson(const CentroidalOcp& ocp, const MpcSolution& solution);

/// Reads them, as strictly as OcpFromJson. Errors call the block `path`.
MpcSolution TrajectoriesFromJson(const CentroidalOcp& ocp, const nlohmann::json& block,
                                 const std::string& path);

/// Reads a solution block of `ocp`, as strictly as OcpFromJson. Iterations are not part of it.
MpcSolution SolutionFromJson(const CentroidalOcp& ocp, const nlohmann::json& json);

}  // namespace sidestep::mpc
