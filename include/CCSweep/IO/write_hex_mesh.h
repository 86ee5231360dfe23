// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_WRITE_HEX_MESH_H
#define CCSWEEP_IO_WRITE_HEX_MESH_H

#include <CCSweep/IO/internal/encoded_file.h>
#include <CCSweep/IO/write_inp.h>
#include <CCSweep/IO/write_msh.h>
#include <CCSweep/IO/write_vtu.h>
#include <CCSweep/Status.h>
#include <CCSweep/hex/Hex_mesh.h>

#include <filesystem>
#include <string>
#include <vector>

namespace CCSweep {

/// Writes a mesh to several files, each in the format of its ending: .vtu, .msh or .inp. All of them are written, or
/// none.
/// \return `write_failed` where that is not possible, `invalid_parameter` for any other ending.
inline Status write_hex_mesh(const Hex_mesh& mesh, const std::vector<std::string>& files,
                             Msh_version version = Msh_version::v4_1) {
  std::vector<internal::Encoded_file> encoded;
  for (const std::filesystem::path file : files) {
    const std::string kind = file.extension().string();
    if (kind == ".vtu")
      encoded.push_back(internal::encoded_vtu(mesh, file));
    else if (kind == ".msh")
      encoded.push_back(internal::encoded_msh(mesh, file, version));
    else if (kind == ".inp")
      encoded.push_back(internal::encoded_inp(mesh, file));
    else
      return {
          Status_code::invalid_parameter, Stage::output, {}, {}, file.string() + " ends with none of .vtu, .msh, .inp"};
  }
  return internal::write_encoded(encoded);
}

}  // namespace CCSweep

#endif
