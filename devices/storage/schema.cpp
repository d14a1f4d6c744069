// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/schema.h"

#include <array>

namespace mb {
namespace {

constexpr const char *firstSchema = R"(
CREATE TABLE trial (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    time REAL NOT NULL,
    device TEXT NOT NULL,
    unit TEXT NOT NULL,
    firmware TEXT NOT NULL,
    simulated INTEGER NOT NULL,
    mode TEXT NOT NULL,
    axis INTEGER NOT NULL,
    slot INTEGER NOT NULL,
    stimulus TEXT NOT NULL,
    envelope TEXT NOT NULL,
    gains TEXT NOT NULL,
    metrics TEXT NOT NULL,
    flags TEXT NOT NULL,
    reason TEXT,
    detail TEXT NOT NULL,
    stopped INTEGER NOT NULL,
    samples INTEGER NOT NULL,
    lost INTEGER NOT NULL,
    star INTEGER NOT NULL DEFAULT 0,
    note TEXT NOT NULL DEFAULT '');
CREATE INDEX trial_device ON trial (device);
CREATE TABLE signal (
    trial INTEGER NOT NULL REFERENCES trial (id) ON DELETE CASCADE,
    channel TEXT NOT NULL,
    unit TEXT NOT NULL,
    samples INTEGER NOT NULL,
    data BLOB NOT NULL,
    PRIMARY KEY (trial, channel)) WITHOUT ROWID;
CREATE TABLE owed (
    trial INTEGER NOT NULL,
    unit TEXT NOT NULL,
    key TEXT NOT NULL,
    raw INTEGER NOT NULL,
    time REAL NOT NULL,
    PRIMARY KEY (trial, key)) WITHOUT ROWID;
CREATE INDEX owed_unit ON owed (unit);
)";

/// Tunings, beside the trials that they are made of.
constexpr const char *secondSchema = R"(
CREATE TABLE tuning (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    time REAL NOT NULL,
    device TEXT NOT NULL,
    unit TEXT NOT NULL,
    firmware TEXT NOT NULL,
    simulated INTEGER NOT NULL,
    loop TEXT NOT NULL,
    axis INTEGER NOT NULL,
    slot INTEGER NOT NULL,
    result TEXT NOT NULL,
    evidence TEXT NOT NULL,
    report TEXT NOT NULL);
CREATE INDEX tuning_unit ON tuning (unit);
)";

/// Snapshots of units, and every write to them.
constexpr const char *thirdSchema = R"(
CREATE TABLE snapshot (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    time REAL NOT NULL,
    unit TEXT NOT NULL,
    device TEXT NOT NULL,
    family TEXT NOT NULL,
    serial TEXT NOT NULL,
    firmware TEXT NOT NULL,
    name TEXT NOT NULL,
    occasion TEXT NOT NULL,
    count INTEGER NOT NULL,
    file TEXT NOT NULL);
CREATE INDEX snapshot_unit ON snapshot (unit);
CREATE TABLE change (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    time REAL NOT NULL,
    unit TEXT NOT NULL,
    device TEXT NOT NULL,
    person TEXT NOT NULL,
    origin TEXT NOT NULL,
    purpose TEXT NOT NULL,
    of INTEGER);
CREATE INDEX change_unit ON change (unit);
CREATE TABLE changed_value (
    change INTEGER NOT NULL REFERENCES change (id) ON DELETE CASCADE,
    place INTEGER NOT NULL,
    key TEXT NOT NULL,
    before INTEGER,
    after INTEGER NOT NULL,
    proof TEXT NOT NULL,
    PRIMARY KEY (change, place)) WITHOUT ROWID;
)";

/// What users call units that have no serial number, by the place where they are connected.
constexpr const char *fourthSchema = R"(
CREATE TABLE tag (
    place TEXT PRIMARY KEY,
    name TEXT NOT NULL,
    time REAL NOT NULL) WITHOUT ROWID;
)";

constexpr std::array versions{firstSchema, secondSchema, thirdSchema, fourthSchema};

} // namespace

std::span<const char *const> schemaVersions()
{
    return versions;
}

} // namespace mb
