// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#define BOOST_TEST_MODULE CCSweep
#include <boost/test/unit_test.hpp>
