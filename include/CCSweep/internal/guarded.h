// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_GUARDED_H
#define CCSWEEP_INTERNAL_GUARDED_H

#include <CCSweep/Status.h>

#include <string>
#include <utility>
#include <vector>

namespace CCSweep::internal {

// Deep helpers throw a Failure; the public function of the stage turns it into a Status, so that no
// exception of ours leaves the library.
struct Failure {
  Status status;
};

[[noreturn]] inline void fail(Status_code code, Stage stage, std::string reason, std::vector<int> patches = {},
                              std::optional<std::array<double, 3>> place = std::nullopt) {
  throw Failure{Status{code, stage, std::move(patches), place, std::move(reason)}};
}

template <class Function>
auto guarded(Function&& function) -> Result<decltype(function())> {
  try {
    return std::forward<Function>(function)();
  } catch (Failure& failure) {
    return std::move(failure.status);
  }
}

// The value of a stage that was called by another one.
template <class T>
T value_or_fail(Result<T> result) {
  if (!result) throw Failure{result.status()};
  return std::move(result).value();
}

}  // namespace CCSweep::internal

#endif
