// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/firmwareshelf.h"

#include "files/filebytes.h"
#include "firmware/firmwareimage.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"

#include <QDateTime>
#include <QDir>
#include <QLocale>
#include <QTimer>

namespace mb {
namespace {

constexpr auto largestImage = static_cast<std::int64_t>(FirmwareImage::maxTextSize);

} // namespace

FirmwareShelf::FirmwareShelf(const QString &folder, QObject *parent)
    : QObject(parent)
    , m_folder(folder)
{
}

void FirmwareShelf::look(const QString &folder)
{
    m_folder = folder;
    ++m_run;
    m_files.clear();
    const QFileInfoList all
        = QDir(folder).entryInfoList({QStringLiteral("*.hex")}, QDir::Files | QDir::Readable, QDir::Time);
    for (const QFileInfo &file : all.mid(0, most))
        m_files.push_back(file);
    m_words.assign(m_files.size(), tr("not read yet"));
    Q_EMIT changed();
    if (!m_files.empty())
        QTimer::singleShot(0, this, [this, run = m_run] { check(0, run); });
}

void FirmwareShelf::check(std::size_t place, int run)
{
    if (run != m_run)
        return;
    const QFileInfo &file = m_files[place];
    const auto bytes = loadFile(file.absoluteFilePath().toStdString(), largestImage);
    if (!bytes) {
        m_words[place] = errorText(bytes.error());
    } else {
        const auto image = FirmwareImage::fromIntelHex(
            std::string_view(bytes->constData(), static_cast<std::size_t>(bytes->size())));
        m_words[place] = image ? tr("%1 · checked · %2")
                                     .arg(formatBytes(static_cast<qint64>(image->byteCount())),
                                         QLocale().toString(file.lastModified().date(), QLocale::ShortFormat))
                               : errorText(image.error());
    }
    Q_EMIT changed();
    if (place + 1 < m_files.size())
        QTimer::singleShot(0, this, [this, place, run] { check(place + 1, run); });
}

std::vector<ListCard::Row> FirmwareShelf::rows() const
{
    std::vector<ListCard::Row> rows;
    for (std::size_t i = 0; i < m_files.size(); ++i)
        rows.push_back({Symbol::Chip, m_files[i].fileName(), m_words[i], tr("Details"),
            QDir::toNativeSeparators(m_files[i].absoluteFilePath())});
    return rows;
}

} // namespace mb
