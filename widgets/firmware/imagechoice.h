// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "firmware/firmwareimage.h"
#include "model/family.h"

#include <QDateTime>
#include <QString>

#include <memory>
#include <optional>

namespace mb {

/// A firmware image that was opened, and what it is to a family; what is wrong with it is kept in words. GUI thread.
class ImageChoice {
public:
    /// Reads it anew; check() is due then.
    void load(const QString &path);
    /// Another file has taken its place since; one that is away is none.
    [[nodiscard]] bool isReplaced() const;
    /// What it is to this family; nullptr: nobody knows.
    void check(const Family *family);

    [[nodiscard]] const QString &path() const { return m_path; }
    /// nullptr: there is none, or it cannot be read.
    [[nodiscard]] const std::shared_ptr<const FirmwareImage> &image() const { return m_image; }
    /// Nothing: it is of no use to the family that it was checked for.
    [[nodiscard]] const std::optional<ImageSummary> &summary() const { return m_summary; }
    /// Name of the file, or that there is none.
    [[nodiscard]] QString name() const;
    /// One line: version and pages, what is wrong, or what to do.
    [[nodiscard]] QString detail() const;
    [[nodiscard]] bool isBad() const { return !m_error.isEmpty(); }
    /// What is worth knowing of it, a line each.
    [[nodiscard]] QString notes() const;
    /// "1.25", or that nobody knows.
    [[nodiscard]] QString version() const;

private:
    QString m_path;
    qint64 m_size = 0; ///< of the file as it was read …
    QDateTime m_time;  ///< … and from when it was
    std::shared_ptr<const FirmwareImage> m_image;
    std::optional<ImageSummary> m_summary;
    QString m_error;
};

} // namespace mb
