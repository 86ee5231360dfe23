// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_INTERNAL_ENCODED_FILE_H
#define CCSWEEP_IO_INTERNAL_ENCODED_FILE_H

#include <CCSweep/IO/internal/staged_files.h>
#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>

#include <filesystem>
#include <list>
#include <string>
#include <utility>
#include <vector>

namespace CCSweep::internal {

// A file that a user asked for, as the names and contents of the files of its folder that are to be written.
struct Encoded_file {
  std::filesystem::path file;
  std::vector<std::pair<std::string, std::string>> contents;
};

// Writes files of any folders, or none of them.
inline Status write_encoded(const std::vector<Encoded_file>& files) {
  return guarded([&] {
           std::list<Staged_files> staged;
           for (const Encoded_file& file : files) {
             const std::filesystem::path folder = file.file.parent_path();
             auto& stage = staged.emplace_back(folder.empty() ? std::filesystem::path(".") : folder);
             for (const auto& [name, content] : file.contents) stage.add(name, content);
           }
           for (Staged_files& stage : staged) stage.commit();
           return true;
         })
      .status();
}

}  // namespace CCSweep::internal

#endif
