// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_INTERNAL_STAGED_FILES_H
#define CCSWEEP_IO_INTERNAL_STAGED_FILES_H

#include <CCSweep/internal/guarded.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CCSweep::internal {

// Files of one folder that appear under their names only when all of them have been written: till then they have
// other names beside, and vanish if it does not come to that.
class Staged_files {
 public:
  explicit Staged_files(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (!std::filesystem::is_directory(folder_, error)) fail_to("make the folder", folder_);
  }

  Staged_files(const Staged_files&) = delete;
  Staged_files& operator=(const Staged_files&) = delete;

  ~Staged_files() {
    std::error_code ignored;
    for (const Staged& file : staged_) std::filesystem::remove(file.temporary, ignored);
  }

  void add(const std::string& name, const std::string& content) {
    const std::filesystem::path path = folder_ / name;
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) fail_to("write over the folder", path);
    const std::filesystem::path temporary = unused_name(path);
    std::ofstream out(temporary, std::ios::binary);
    if (!out) fail_to("write", path);
    staged_.push_back({temporary, path});
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    if (!out) fail_to("write all of", path);
  }

  void commit() {
    for (; !staged_.empty(); staged_.pop_back()) {
      std::error_code error;
      std::filesystem::rename(staged_.back().temporary, staged_.back().path, error);
      if (error) fail_to("write", staged_.back().path);
    }
  }

 private:
  struct Staged {
    std::filesystem::path temporary, path;
  };

  static std::filesystem::path unused_name(const std::filesystem::path& path) {
    std::random_device random;
    std::filesystem::path name;
    std::error_code ignored;
    do {
      name = path;
      name += ".part" + std::to_string(random());
    } while (std::filesystem::exists(name, ignored));
    return name;
  }

  [[noreturn]] static void fail_to(const std::string& what, const std::filesystem::path& path) {
    fail(Status_code::write_failed, Stage::output, "can't " + what + " " + path.string());
  }

  std::filesystem::path folder_;
  std::vector<Staged> staged_;
};

}  // namespace CCSweep::internal

#endif
