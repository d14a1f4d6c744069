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

/// What was done to which unit, in words that PostgreSQL understands, too: it is the schema of a shared journal. A visit is one
/// unit under one recipe, once; `revision` counts its writes. What is given of a scope's numbers to nobody yet has no unit.
constexpr const char *fifthSchema = R"(
CREATE TABLE service_visit (
    id TEXT PRIMARY KEY,
    revision BIGINT NOT NULL,
    run TEXT NOT NULL,
    time DOUBLE PRECISION NOT NULL,
    station TEXT NOT NULL,
    person TEXT NOT NULL,
    recipe TEXT NOT NULL,
    recipe_hash TEXT NOT NULL,
    image_hash TEXT NOT NULL,
    unit TEXT NOT NULL,
    serial TEXT NOT NULL,
    device TEXT NOT NULL,
    family TEXT NOT NULL,
    simulated BIGINT NOT NULL,
    step TEXT NOT NULL,
    outcome TEXT NOT NULL,
    firmware_before TEXT NOT NULL,
    firmware_after TEXT NOT NULL,
    parameters BIGINT,
    test TEXT NOT NULL,
    number BIGINT,
    snapshot BIGINT,
    trial BIGINT,
    seconds DOUBLE PRECISION NOT NULL,
    cause TEXT NOT NULL,
    remedy TEXT NOT NULL,
    evidence TEXT NOT NULL,
    note TEXT NOT NULL);
CREATE INDEX service_visit_unit ON service_visit (unit);
CREATE INDEX service_visit_serial ON service_visit (serial);
CREATE INDEX service_visit_run ON service_visit (run);
CREATE INDEX service_visit_recipe ON service_visit (recipe, recipe_hash);
CREATE TABLE service_step (
    visit TEXT NOT NULL REFERENCES service_visit (id) ON DELETE CASCADE,
    place BIGINT NOT NULL,
    step TEXT NOT NULL,
    time DOUBLE PRECISION NOT NULL,
    ended BIGINT NOT NULL,
    detail TEXT NOT NULL,
    PRIMARY KEY (visit, place));
CREATE TABLE service_delivery (
    visit TEXT PRIMARY KEY,
    revision BIGINT NOT NULL);
CREATE TABLE service_scope (
    scope TEXT PRIMARY KEY,
    next BIGINT NOT NULL);
CREATE TABLE service_block (
    token TEXT PRIMARY KEY,
    scope TEXT NOT NULL,
    first BIGINT NOT NULL,
    last BIGINT NOT NULL,
    station TEXT NOT NULL,
    time DOUBLE PRECISION NOT NULL);
CREATE TABLE service_number (
    scope TEXT NOT NULL,
    number BIGINT NOT NULL,
    unit TEXT NOT NULL,
    visit TEXT NOT NULL,
    PRIMARY KEY (scope, number));
)";

/// What of a unit that has failed concerns the others too: service::Ending. For a shared journal as well.
constexpr const char *sixthSchema = R"(
ALTER TABLE service_visit ADD COLUMN ending TEXT NOT NULL DEFAULT '';
)";

/// A unit is owed one value of each key, that of before the first trial.
constexpr const char *seventhSchema = R"(
CREATE TABLE owed_value (
    unit TEXT NOT NULL,
    key TEXT NOT NULL,
    trial INTEGER NOT NULL,
    raw INTEGER NOT NULL,
    tried INTEGER,
    put_back INTEGER NOT NULL,
    time REAL NOT NULL,
    PRIMARY KEY (unit, key)) WITHOUT ROWID;
INSERT INTO owed_value SELECT unit, key, min(trial), raw, NULL, 0, time FROM owed GROUP BY unit, key;
DROP TABLE owed;
ALTER TABLE owed_value RENAME TO owed;
)";

/// Who makes a trial, while it is made (thisProgram); empty afterwards.
constexpr const char *eighthSchema = R"(
ALTER TABLE trial ADD COLUMN program TEXT NOT NULL DEFAULT '';
)";

/// That new firmware was written to a unit and nothing proves it. For a shared journal as well.
constexpr const char *ninthSchema = R"(
ALTER TABLE service_visit ADD COLUMN unproved BIGINT NOT NULL DEFAULT 0;
)";

/// What each server of a shared journal has; what was delivered before may be so again. Which program has begun a run of a queue.
/// What was undone and redone before anybody was asked to keep that is kept.
constexpr const char *tenthSchema = R"(
DROP TABLE service_delivery;
CREATE TABLE service_delivery (
    visit TEXT NOT NULL,
    server TEXT NOT NULL,
    revision INTEGER NOT NULL,
    PRIMARY KEY (visit, server)) WITHOUT ROWID;
CREATE TABLE service_run (
    run TEXT PRIMARY KEY,
    program TEXT NOT NULL) WITHOUT ROWID;
INSERT INTO change (time, unit, device, person, origin, purpose, of)
    SELECT time, unit, device, person, origin, 'keep', id FROM change WHERE purpose IN ('undo', 'redo');
)";

constexpr std::array versions{firstSchema, secondSchema, thirdSchema, fourthSchema, fifthSchema, sixthSchema,
    seventhSchema, eighthSchema, ninthSchema, tenthSchema};
constexpr std::array journalVersions{fifthSchema, sixthSchema, ninthSchema};

} // namespace

std::span<const char *const> schemaVersions()
{
    return versions;
}

std::span<const char *const> journalSchemaVersions()
{
    return journalVersions;
}

} // namespace mb
