// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/world_model.h"

#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "models/mjcf/ground.h"
#include "models/support/config_node.h"
#include "models/support/require.h"
#include "sim/scenario/scenario.h"
#include "sim/world/box_contacts.h"
#include "sim/world/ground.h"

namespace sidestep {
namespace {

constexpr double kFootPlateThickness_m = 0.02;  // of the centroidal plant's drawn feet
constexpr double kSlabDepth_m = 1.0;            // deeper than any foot gets, so its top is nearest
constexpr int kWorldBody = 0;                   // carries the ground
constexpr char kOtherFriction[] = " 0.005 0.0001 0.0001";  // of a pair: MuJoCo's defaults

// Sky, light and how they look.
std::string Surroundings() {
  return R"(
  <visual>
    <headlight ambient="0.35 0.35 0.35" diffuse="0.35 0.35 0.35" specular="0.1 0.1 0.1"/>
    <map znear="0.02" zfar="60" fogstart="8" fogend="25"/>
    <rgba fog="0.80 0.86 0.92 1" haze="0.80 0.86 0.92 1"/>
  </visual>
  <asset>
    <texture name="sky" type="skybox" builtin="gradient" rgb1="0.80 0.86 0.92"
             rgb2="0.42 0.56 0.74" width="64" height="384"/>
    <texture name="floor" type="2d" builtin="checker" rgb1="0.78 0.80 0.82"
             rgb2="0.68 0.70 0.73" width="256" height="256"/>
    <material name="floor" texture="floor" texrepeat="2 2" texuniform="true" specular="0.1"
              reflectance="0"/>
  </asset>
  <worldbody>
    <light name="sun" directional="true" pos="0 0 6" dir="-0.35 0.45 -1" diffuse="0.6 0.6 0.6"
           castshadow="true"/>
  </worldbody>
)";
}

std::string SlabGeom(std::size_t slab) {
  return std::string(kGroundGeom) + "_" + std::to_string(slab);
}

// The foot's geoms have a higher priority than the ground, so that their own contact parameters
// hold; sliding friction is set on every geom afterwards.
void WriteGroundGeom(const std::string& name, const std::string& shape, std::ostream& xml) {
  xml << "<geom name=\"" << name << "\" " << shape
      << " material=\"floor\" condim=\"3\" contype=\"1\" conaffinity=\"1\" group=\"0\"/>";
}

// A plane at the lowest height, and boxes whose tops are what lies higher.
void WriteGround(const std::vector<GroundPatch>& ground, std::ostream& xml) {
  std::ostringstream plane;
  plane << "type=\"plane\" size=\"0 0 0.5\"";
  if (!ground.empty()) plane << " pos=\"0 0 " << NumberText(LowestGround_m(ground)) << "\"";
  xml << "<worldbody>";
  WriteGroundGeom(kGroundGeom, plane.str(), xml);
  const std::vector<GroundSlab> slabs = GroundSlabs(ground);
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    const GroundSlab& slab = slabs[i];
    std::ostringstream box;
    box << "type=\"box\" size=\"" << NumberText(0.5 * (slab.to_x_m - slab.from_x_m)) << " "
        << NumberText(0.5 * (slab.to_y_m - slab.from_y_m)) << " " << 0.5 * kSlabDepth_m
        << "\" pos=\"" << NumberText(0.5 * (slab.from_x_m + slab.to_x_m)) << " "
        << NumberText(0.5 * (slab.from_y_m + slab.to_y_m)) << " "
        << NumberText(slab.height_m - 0.5 * kSlabDepth_m) << "\"";
    WriteGroundGeom(SlabGeom(i), box.str(), xml);
  }
  xml << "</worldbody>";
}

// Half extents of the rectangle that holds the foot's vertices.
Eigen::Vector3d FootHalfExtent_m(const FootDescription& foot) {
  return 0.5 * (foot.vertices_m.rowwise().maxCoeff() - foot.vertices_m.rowwise().minCoeff());
}

// A ball for the CoM and a plate or a small ball for each foot, moved by hand, touching nothing.
std::string CentroidalStandIn(const RobotDescription& robot) {
  std::ostringstream xml;
  xml << "<default><geom contype=\"0\" conaffinity=\"0\" group=\"1\"/></default><worldbody>"
      << "<body name=\"com\" pos=\"0 0 " << robot.com_height_m << "\"><freejoint/>"
      << "<geom type=\"sphere\" size=\"0.06\" rgba=\"0.10 0.45 0.78 1\" mass=\"" << robot.mass_kg
      << "\"/></body>";
  for (const FootDescription& foot : robot.feet) {
    const Eigen::Vector3d half_m = FootHalfExtent_m(foot);
    xml << "<body name=\"" << foot.name << "\"><freejoint/>";
    if (half_m.head<2>().minCoeff() > 0.0) {
      xml << "<geom type=\"box\" size=\"" << half_m.x() << " " << half_m.y() << " "
          << 0.5 * kFootPlateThickness_m << "\" pos=\"0 0 " << 0.5 * kFootPlateThickness_m << "\"";
    } else {
      xml << "<geom type=\"sphere\" size=\"0.025\" pos=\"0 0 0.025\"";
    }
    xml << " rgba=\"0.16 0.18 0.22 1\" mass=\"0.01\"/></body>";
  }
  xml << "</worldbody>";
  return xml.str();
}

// A URDF's shapes touch only what is listed, so its world names the pairs: MuJoCo's search for
// others (a sweep over all bodies, sorted anew) takes a fifth of the iCub's step and finds none.
// The pairs are the plane's; each slab has the same.
std::string ListedContacts(const RobotModel& model, const std::vector<GroundPatch>& ground) {
  if (model.ground_pairs.empty()) return {};
  std::string pairs = model.ground_pairs;
  const std::string plane = "geom1=\"" + std::string(kGroundGeom) + "\"";
  const std::size_t num_slabs = GroundSlabs(ground).size();
  for (std::size_t i = 0; i < num_slabs; ++i) {
    std::string slab_pairs = model.ground_pairs;
    const std::string slab = "geom1=\"" + SlabGeom(i) + "\"";
    for (std::size_t at = 0; (at = slab_pairs.find(plane, at)) != std::string::npos;) {
      slab_pairs.replace(at, plane.size(), slab);
    }
    pairs += slab_pairs;
  }
  return "<option collision=\"predefined\"/><contact>" + pairs + "</contact>";
}

// Sliding friction of the ground with everything.
void SetFriction(double friction, mjModel* model) {
  for (int geom = 0; geom < model->ngeom; ++geom) model->geom_friction[3 * geom] = friction;
  for (int pair = 0; pair < model->npair; ++pair) {
    if (model->geom_bodyid[model->pair_geom1[pair]] != kWorldBody &&
        model->geom_bodyid[model->pair_geom2[pair]] != kWorldBody) {
      continue;
    }
    model->pair_friction[5 * pair] = friction;
    model->pair_friction[5 * pair + 1] = friction;
  }
}

// Every body heavier at the same shape. What MuJoCo derives from masses is derived again.
void ScaleMasses(double scale, mjModel* model) {
  if (scale == 1.0) return;
  mju_scl(model->body_mass, model->body_mass, scale, model->nbody);
  mju_scl(model->body_inertia, model->body_inertia, scale, 3 * model->nbody);
  const MjDataPtr data = MakeData(*model);
  mj_setConst(model, data.get());
}

/// What is written into a world's document beside its surroundings.
struct Inhabitant {
  std::string xml;                   ///< May include robot.xml.
  std::string robot_xml;             ///< Text of robot.xml; empty: none is included.
  std::filesystem::path file;        ///< Named where it does not compile.
  const RobotModel* model{nullptr};  ///< Whose listed contacts it has; may be null.
};

std::string WorldText(const std::string& name, const Inhabitant& inhabitant,
                      const WorldParams& params) {
  std::ostringstream xml;
  xml << "<mujoco model=\"" << name << "_world\">"
      << "<option timestep=\"" << NumberText(params.step_s) << "\" integrator=\"Euler\"/>"
      << Surroundings();
  WriteGround(params.ground, xml);
  xml << inhabitant.xml;
  if (inhabitant.model != nullptr) xml << ListedContacts(*inhabitant.model, params.ground);
  xml << "</mujoco>";
  return xml.str();
}

MjModelPtr Compile(const std::string& name, const Inhabitant& inhabitant,
                   const WorldParams& params) {
  MjModelPtr model =
      CompileMjcf(WorldText(name, inhabitant, params), inhabitant.robot_xml, inhabitant.file);
  SetFriction(params.friction, model.get());
  ScaleMasses(params.mass_scale, model.get());
  if (params.ground.empty()) return model;
  DropImpossibleBoxContacts();
  // Slabs reach far, but light and camera go by the size of what stands on the ground.
  WorldParams level = params;
  level.ground.clear();
  model->stat = Compile(name, inhabitant, level)->stat;
  return model;
}

Inhabitant RobotIn(const RobotDescription& robot, ModelDetail detail) {
  const RobotModel& model = RequireModel(robot);
  return {"<include file=\"robot.xml\"/>", model.mjcf(detail), model.file, &model};
}

Inhabitant StandInOf(const RobotDescription& robot) {
  return {CentroidalStandIn(robot), "", robot.file, nullptr};
}

// What an <include> of the document would put in its place.
std::string InsideOf(const std::string& mjcf) {
  const std::size_t tag = mjcf.find("<mujoco");
  const std::size_t begin = mjcf.find('>', tag);
  const std::size_t end = mjcf.rfind("</mujoco>");
  SIDESTEP_REQUIRE(tag != std::string::npos && end != std::string::npos && begin < end, tag);
  return mjcf.substr(begin + 1, end - begin - 1);
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

// What SetFriction() does, in words: the first number of each geom's friction is the world's, while
// pairs of the robot's own shapes keep MuJoCo's default.
std::string WithFriction(const std::string& robot_xml, const std::string& friction) {
  static const std::regex kSliding("(\\sfriction\\s*=\\s*[\"']\\s*)[^\\s\"']+");
  return "<default><geom friction=\"" + friction + "\"/><pair friction=\"1 1" + kOtherFriction +
         "\"/></default>" + std::regex_replace(robot_xml, kSliding, "$01" + friction);
}

}  // namespace

MjModelPtr CompileRobotWorld(const RobotDescription& robot, const WorldParams& params,
                             ModelDetail detail) {
  return Compile(robot.name, RobotIn(robot, detail), params);
}

MjModelPtr CompileCentroidalStandIn(const RobotDescription& robot, const WorldParams& params) {
  return Compile(robot.name, StandInOf(robot), params);
}

std::string DrawnWorldMjcf(const RobotDescription& robot) {
  const WorldParams params;
  const std::string friction = NumberText(params.friction);
  Inhabitant inhabitant = robot.model ? RobotIn(robot, ModelDetail::kDrawn) : StandInOf(robot);
  RobotModel model;
  if (robot.model) {
    inhabitant.xml = WithFriction(InsideOf(inhabitant.robot_xml), friction);
    model.ground_pairs =
        Replaced(inhabitant.model->ground_pairs, "<pair ",
                 "<pair friction=\"" + friction + " " + friction + kOtherFriction + "\" ");
    inhabitant.model = &model;
  }
  return WorldText(robot.name, inhabitant, params);
}

std::string SimulatedMjcf(const Scenario& scenario) {
  const Inhabitant inhabitant = RobotIn(scenario.robot, ModelDetail::kSimulated);
  return WorldText(scenario.robot.name, inhabitant, scenario.world) + inhabitant.robot_xml;
}

MjModelPtr CompileDrawnWorld(const Scenario& scenario) {
  const RobotDescription& robot = scenario.robot;
  return scenario.plant == Plant::kCentroidal
             ? CompileCentroidalStandIn(robot, scenario.world)
             : CompileRobotWorld(robot, scenario.world, ModelDetail::kDrawn);
}

}  // namespace sidestep
