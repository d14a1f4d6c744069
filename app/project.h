// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"
#include "model/trialtraits.h"

#include <QJsonObject>
#include <QStringList>

namespace mb {

class EnvelopeBook;

/// A unit of a machine, as far as this program knows more of it than the unit itself does.
struct ProjectUnit {
    std::string selector;
    std::string unit;  ///< who it is across links, as limits and trials name it
    std::string title; ///< "DMC60C #5", for people
    std::string name;
    std::string serial;
    std::string dialect; ///< chosen against the scan; empty: none
    std::map<std::string, double> calibration;
    Envelope limits;        ///< of experiments
    QJsonObject parameters; ///< as `motorbenchctl get` has them; empty where none could be read

    friend bool operator==(const ProjectUnit &, const ProjectUnit &) = default;
};

/// Everything of a machine in one folder, to be put under version control: `project.json` with links and units, `parameters/`
/// with a file for each unit, `plots/` with layouts. Files are written whole, sorted, one key a line, and only where they differ.
struct Project {
    QStringList links;
    std::vector<ProjectUnit> units;
    QString layouts; ///< folder of layouts to copy from or to; empty: none

    /// What is open now.
    [[nodiscard]] static Project of(const Snapshot &shot, const EnvelopeBook &limits);
    [[nodiscard]] Result<void> save(const QString &folder) const;
    /// OutOfRange with the file and its cause; nothing is half taken.
    [[nodiscard]] static Result<Project> load(const QString &folder);
    /// The unit of a device: by its serial number, else by its place.
    [[nodiscard]] const ProjectUnit *unitOf(const DeviceView &device) const;
};

/// Into a folder that is made where it is not there yet; `over`: also what has the name of another one there.
[[nodiscard]] Result<void> copyLayouts(const QString &from, const QString &to, bool over);

} // namespace mb
