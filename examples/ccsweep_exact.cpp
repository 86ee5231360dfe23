// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The command line program with exact constructions.
#include "ccsweep_run.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

template CCSweep::Status program::run<CGAL::Exact_predicates_exact_constructions_kernel>(const program::Options&,
                                                                                          program::Progress&);
