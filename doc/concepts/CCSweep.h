// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \defgroup Concepts Concepts
/// What a user's types must be to take the place of the library's.

/// Decomposition of multi-sweep volumes into many-to-one sweepable sub-volumes. Begin with `decompose()`.
namespace CCSweep {}
