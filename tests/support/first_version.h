#pragma once
// Session files of version 1, made of such of today.

#include "engine/recording/session_store.h"

#include <array>
#include <string>
#include <vector>

namespace bask::test {

/// Gives a finished session the tables that version 1 had. False when it cannot.
inline bool makeFirstVersion(const std::string& path) {
    constexpr std::array kViews{"sample", "object_state", "truth", "pose", "motion", "source", "source_pose"};
    constexpr std::array kLater{"step", "object", "target_step", "overview"};
    std::vector<std::string> statements{"PRAGMA journal_mode = DELETE", "BEGIN"};
    for (const std::string view : kViews)
        statements.push_back("CREATE TABLE old_" + view + " AS SELECT * FROM " + view);
    for (const std::string view : kViews)
        statements.push_back("DROP VIEW " + view);
    for (const std::string table : kLater)
        statements.push_back("DROP TABLE " + table);
    for (const std::string view : kViews)
        statements.push_back("ALTER TABLE old_" + view + " RENAME TO " + view);
    for (const char* sql : {"PRAGMA user_version = 1", "COMMIT", "PRAGMA page_size = 4096", "VACUUM"})
        statements.emplace_back(sql);
    const auto store = SessionStore::create(path);
    for (const std::string& sql : statements)
        if (!store || !(*store)->execute(sql))
            return false;
    return true;
}

} // namespace bask::test
