// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/imagechoice.h"

#include "files/filebytes.h"
#include "widgets/common/devicetext.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace mb {
namespace {

constexpr std::int64_t largestFile = 16 * 1024 * 1024;

struct ImageText {
    Q_DECLARE_TR_FUNCTIONS(mb::ImageText)
};

} // namespace

void ImageChoice::load(const QString &path)
{
    const QFileInfo file(path);
    m_path = path;
    m_size = file.size();
    m_time = file.lastModified();
    m_image.reset();
    m_summary.reset();
    m_error.clear();
    const auto bytes = loadFile(path.toStdString(), largestFile);
    if (!bytes) {
        m_error = errorText(bytes.error());
        return;
    }
    auto image
        = FirmwareImage::fromIntelHex(std::string_view(bytes->constData(), static_cast<std::size_t>(bytes->size())));
    if (image)
        m_image = std::make_shared<const FirmwareImage>(std::move(*image));
    else
        m_error = errorText(image.error());
}

bool ImageChoice::isReplaced() const
{
    const QFileInfo file(m_path);
    return file.exists() && (file.size() != m_size || file.lastModified() != m_time);
}

void ImageChoice::check(const Family *family)
{
    m_summary.reset();
    if (!m_image || !family || !family->inspect)
        return;
    auto summary = family->inspect(*m_image);
    m_error = summary ? QString() : errorText(summary.error());
    if (summary)
        m_summary = std::move(*summary);
}

QString ImageChoice::name() const
{
    return m_path.isEmpty() ? ImageText::tr("no image yet") : QFileInfo(m_path).fileName();
}

/// Notes say what there is to say of a file without a version.
QString ImageChoice::detail() const
{
    if (isBad())
        return m_error;
    if (!m_summary)
        return m_path.isEmpty() ? ImageText::tr("Open an Intel HEX file, or drop it here")
                                : ImageText::tr("select a device to check it");
    if (m_summary->version.empty() && !m_summary->notes.empty())
        return messageText(m_summary->notes.front());
    return ImageText::tr("version %1 · pages: %2")
        .arg(QString::fromStdString(m_summary->version))
        .arg(m_summary->parts.size());
}

QString ImageChoice::notes() const
{
    QStringList notes;
    for (const Message &note : m_summary ? m_summary->notes : std::vector<Message>{})
        notes += messageText(note);
    return notes.join(QLatin1Char('\n'));
}

QString ImageChoice::version() const
{
    return !m_summary || m_summary->version.empty() ? ImageText::tr("unknown")
                                                    : QString::fromStdString(m_summary->version);
}

} // namespace mb
