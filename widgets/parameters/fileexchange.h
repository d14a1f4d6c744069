// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"
#include "widgets/parameters/parameterview.h"

#include <memory>

namespace mb {

class BannerStack;

/// A parameter file that is looked at by itself, without a device.
struct OpenedFile {
    const Family *family = nullptr;
    QString name;
    std::unique_ptr<StagedEdits> edits;
};

/// Parameter files, in and out. A notice says what came of each; that of an import takes it back, as long as it is the last edit.
class FileExchange : public QObject {
    Q_OBJECT
public:
    /// `view` shows what is staged; a field that is open in it is taken first.
    FileExchange(Workbench &workbench, BannerStack &banners, ParameterView &view);

    /// Stages what differs from the file; whether anything was. Another family's file is refused.
    bool importInto(const DeviceView &device, const QString &path);
    /// What was imported is written, or not wanted any more.
    void endImport();
    void exportOf(const DeviceView &device, const QString &path);
    /// The values of the file, to be compared with those of `owner`.
    [[nodiscard]] std::optional<ParameterReference> referenceOf(
        const QString &path, const Family &family, const QString &owner);
    /// Nothing where the file is refused.
    [[nodiscard]] std::optional<OpenedFile> open(const QString &path);

private:
    void act(const QString &key);
    void stage(const DeviceView &device, const QString &name, const std::vector<ParameterChange> &changes,
        const std::vector<Message> &leftOut);

    Workbench &m_workbench;
    BannerStack &m_banners;
    ParameterView &m_view;
    DeviceId m_importedInto;
    QMetaObject::Connection m_later; ///< edits after the import
};

} // namespace mb
