// SPDX-License-Identifier: MIT
#pragma once
/// The integrators of SUNDIALS with the interface of the project's own, where SUNDIALS is installed: link with
/// torsor::runtime_sundials.
#include "torsor/runtime/sundials/arkode.hpp"
#include "torsor/runtime/sundials/cvode.hpp"
#include "torsor/runtime/sundials/ida.hpp"
