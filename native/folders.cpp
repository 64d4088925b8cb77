// SPDX-License-Identifier: MIT
#include "folders.h"

#include <algorithm>
#include <filesystem>

namespace versorium {

namespace fs = std::filesystem;

Expected<Folder> listFolder(const std::string& path) {
    std::error_code error;
    const fs::path where = path.empty() ? fs::current_path(error) : fs::canonical(path, error);
    if (error) return Status::inputOutput(path + ": " + error.message());
    fs::directory_iterator entries(where, error);
    if (error) return Status::inputOutput(where.string() + ": " + error.message());
    Folder folder{where.string(), {}};
    for (; entries != fs::directory_iterator(); entries.increment(error)) {
        if (error) break;
        const std::string name = entries->path().filename().string();
        const bool isFolder = entries->is_directory(error);
        if (!name.empty() && name[0] != '.' && !error) folder.entries.push_back({name, isFolder});
    }
    std::sort(folder.entries.begin(), folder.entries.end(),
              [](const FolderEntry& a, const FolderEntry& b) {
                  return a.isFolder != b.isFolder ? a.isFolder : a.name < b.name;
              });
    if (where.has_relative_path()) folder.entries.insert(folder.entries.begin(), {"..", true});
    return folder;
}

}  // namespace versorium
