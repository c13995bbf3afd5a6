// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// isa: the name of the instruction set that a translation unit is compiled for.
//
// The numerical core is compiled once for any x86-64 and once for AVX2 with FMA; each copy lives
// in a namespace of its own, and the program picks one at run time. So that no inline function of
// a library is emitted with instructions that another processor lacks, the core includes neither
// Eigen nor the standard containers.

#ifndef SIDESTEP_ISA
#define SIDESTEP_ISA baseline
#endif
