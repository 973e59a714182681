# SPDX-License-Identifier: MIT
"""The structures of runtime/abi.h for ctypes, and the libraries that have them."""

from __future__ import annotations

import ctypes
import os
from ctypes import (CDLL, CFUNCTYPE, POINTER, Structure, c_char_p, c_double, c_int32, c_int64, c_size_t, c_ssize_t,
                    c_uint32, c_uint64, c_void_p)

VERSION = 2


class Quantity(Structure):
    _fields_ = [("name", c_char_p), ("unit", c_char_p)]


class Result(Structure):
    _fields_ = [("name", c_char_p), ("rows", c_int32), ("columns", c_int32), ("dimensions", c_int32), ("unit", c_char_p)]


class View(Structure):
    _fields_ = [("data", c_void_p), ("state", c_ssize_t), ("row", c_ssize_t), ("column", c_ssize_t)]


class Call(Structure):
    _fields_ = [("model", c_void_p), ("states", c_size_t), ("threads", c_uint32), ("order", c_int32), ("time", View),
                ("q", View), ("v", View), ("accelerations", View), ("multipliers", View), ("inputs", View),
                ("results", POINTER(View)), ("statuses", c_void_p), ("worst", c_int32)]


Evaluate = CFUNCTYPE(c_int64, c_void_p)


class KernelEntry(Structure):
    _fields_ = [("name", c_char_p), ("reads_accelerations", c_int32), ("reads_multipliers", c_int32),
                ("reads_inputs", c_int32), ("has_status", c_int32), ("takes_order", c_int32),
                ("result_count", c_int32), ("results", POINTER(Result)), ("evaluate", Evaluate)]


InputLaw = CFUNCTYPE(None, c_void_p, c_double, POINTER(c_double), POINTER(c_double))


class Motion(Structure):
    _fields_ = [("model", c_void_p), ("motions", c_size_t), ("threads", c_uint32), ("method", c_int32),
                ("unprojected", c_int32), ("step", c_double), ("relative_tolerance", c_double),
                ("absolute_tolerance", c_double), ("first_step", c_double), ("largest_step", c_double),
                ("step_limit", c_int64), ("time", View), ("start", View), ("inputs", View), ("law", InputLaw),
                ("context", c_void_p), ("times", c_void_p), ("time_count", c_size_t), ("states", View),
                ("statuses", c_void_p), ("ends", c_void_p), ("calls", c_void_p)]


class Method(Structure):
    _fields_ = [("name", c_char_p), ("fixed_step", c_int32)]


class ContactEntry(Structure):
    _fields_ = [("name", c_char_p), ("gap_unit", c_char_p), ("reaction_unit", c_char_p), ("normal", c_int32),
                ("tangents", c_int32)]


class ContactEventEntry(Structure):
    _fields_ = [("motion", c_size_t), ("kind", c_int32), ("contact", c_int32), ("time", c_double),
                ("before", POINTER(c_double)), ("after", POINTER(c_double)), ("regimes", POINTER(c_int32)),
                ("impulses", POINTER(c_double)), ("energy_lost", c_double)]


ContactObserver = CFUNCTYPE(c_int32, c_void_p, POINTER(ContactEventEntry))


class ContactMotion(Structure):
    _fields_ = [("motion", Motion), ("impact_law", c_int32), ("impact_without_collision", c_int32), ("touch", c_double),
                ("at_rest", c_double), ("accumulation", c_double), ("event_limit", c_int64),
                ("observer", ContactObserver), ("observer_context", c_void_p), ("regimes", c_void_p),
                ("contacts", c_void_p)]


class Table(Structure):
    _fields_ = [("version", c_uint32), ("size", c_uint32), ("name", c_char_p), ("fingerprint", c_uint64),
                ("lanes", c_uint32), ("coordinate_count", c_int32), ("velocity_count", c_int32),
                ("input_count", c_int32), ("multiplier_count", c_int32), ("parameter_count", c_int32),
                ("coordinates", POINTER(Quantity)), ("velocities", POINTER(Quantity)), ("inputs", POINTER(Quantity)),
                ("multipliers", POINTER(Quantity)), ("parameters", POINTER(Quantity)),
                ("default_parameters", POINTER(c_double)), ("quaternion_count", c_int32),
                ("quaternions", POINTER(c_int32)), ("kernel_count", c_int32), ("kernels", POINTER(KernelEntry)),
                ("method_count", c_int32), ("methods", POINTER(Method)),
                ("create", CFUNCTYPE(c_void_p, POINTER(c_double))), ("destroy", CFUNCTYPE(None, c_void_p)),
                ("initial_state", CFUNCTYPE(None, c_void_p, POINTER(c_double), POINTER(c_double), POINTER(c_double))),
                ("integrate", CFUNCTYPE(c_int64, c_void_p)), ("contact_count", c_int32), ("contact_row_count", c_int32),
                ("contacts", POINTER(ContactEntry)), ("integrate_contacts", CFUNCTYPE(c_int64, c_void_p)),
                ("impossible", CFUNCTYPE(c_char_p, c_void_p))]


def open_library(path: str) -> tuple[CDLL, Table]:
    """The library and its table. Raises OSError where there is none, or one of another version."""
    path = os.path.abspath(os.fspath(path))
    library = CDLL(path)
    try:
        entry = library.torsor_mechanism
    except AttributeError:
        raise OSError(f"{path} has no symbol torsor_mechanism: make it with `torsor build`") from None
    entry.restype = POINTER(Table)
    table = entry().contents
    if table.version != VERSION or table.size < ctypes.sizeof(Table) - ctypes.sizeof(c_void_p):  # older ones lack `impossible`
        raise OSError(f"{path} has version {table.version} of the interface and this package version {VERSION}: "
                      "build the library again")
    return library, table
