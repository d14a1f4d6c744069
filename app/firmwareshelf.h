// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/start/listcard.h"

#include <QFileInfo>
#include <QObject>

#include <vector>

namespace mb {

/// Firmware images in a folder, newest first, each read and checked, one a turn of the event loop. GUI thread.
class FirmwareShelf : public QObject {
    Q_OBJECT
public:
    /// At most so many are listed.
    static constexpr int most = 6;

    explicit FirmwareShelf(const QString &folder, QObject *parent = nullptr);

    [[nodiscard]] const QString &folder() const { return m_folder; }
    void look(const QString &folder);
    [[nodiscard]] std::vector<ListCard::Row> rows() const;
    [[nodiscard]] QString path(int row) const { return m_files.at(static_cast<std::size_t>(row)).absoluteFilePath(); }

Q_SIGNALS:
    void changed();

private:
    void check(std::size_t place, int run);

    QString m_folder;
    std::vector<QFileInfo> m_files;
    std::vector<QString> m_words; ///< what is known of each
    int m_run = 0;                ///< an earlier look is over
};

} // namespace mb
