// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/helpbrowser.h"

#include <QDesktopServices>
#include <QFile>
#include <QFontDatabase>
#include <QImage>
#include <QPainter>
#include <QResizeEvent>
#include <QScrollBar>
#include <QSvgRenderer>
#include <QTextBlock>
#include <QTextTable>

#include <algorithm>
#include <utility>
#include <vector>

namespace mb {
namespace {

constexpr double designPoints = 10.0; ///< font size that drawings are made for

QString pathOf(const QString &topic)
{
    return QStringLiteral(":/help/%1.md").arg(topic);
}

} // namespace

HelpBrowser::HelpBrowser(const ThemeSource &theme, QWidget *parent)
    : QTextBrowser(parent)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("helpPage"));
    setAccessibleName(tr("Help"));
    setOpenLinks(false);
    setFrameShape(QFrame::NoFrame);
    document()->setDocumentMargin(theme.theme().u(16));
    connect(this, &QTextBrowser::anchorClicked, this, &HelpBrowser::follow);
    connect(&theme, &ThemeSource::changed, this, &HelpBrowser::fill);
    m_resized.setSingleShot(true);
    connect(&m_resized, &QTimer::timeout, this, &HelpBrowser::refill);
}

bool HelpBrowser::showPage(const QString &topic)
{
    if (!QFile::exists(pathOf(topic)))
        return false;
    m_topic = topic;
    fill();
    verticalScrollBar()->setValue(0);
    return true;
}

void HelpBrowser::fill()
{
    QFile file(pathOf(m_topic));
    if (!file.open(QIODevice::ReadOnly))
        return;
    document()->clear(); // drawings of another theme are kept by their name
    document()->setBaseUrl(QUrl(QStringLiteral("qrc") + pathOf(m_topic)));
    document()->setMarkdown(QString::fromUtf8(file.readAll()), QTextDocument::MarkdownDialectGitHub);
    dressTables();
    dressCode();
    moveCursor(QTextCursor::Start);
}

/// As the tables of the program: lines between the rows, room around the words.
void HelpBrowser::dressTables()
{
    const Theme &theme = m_theme.theme();
    for (QTextFrame *frame : document()->rootFrame()->childFrames()) {
        auto *table = qobject_cast<QTextTable *>(frame);
        if (!table)
            continue;
        QTextTableFormat format = table->format();
        format.setBorderCollapse(true);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorder(1);
        format.setBorderBrush(theme.line);
        format.setCellPadding(theme.u(6));
        format.setCellSpacing(0);
        format.setTopMargin(theme.u(4));
        format.setBottomMargin(theme.u(8));
        table->setFormat(format);
    }
}

/// Commands and names of the wire in the font for such things.
void HelpBrowser::dressCode()
{
    QTextCharFormat code;
    code.setFontFamily(QFontDatabase::systemFont(QFontDatabase::FixedFont).family());
    std::vector<std::pair<int, int>> places;
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        for (auto part = block.begin(); !part.atEnd(); ++part) {
            const QTextFragment words = part.fragment();
            if (words.charFormat().fontFixedPitch())
                places.emplace_back(words.position(), words.position() + words.length());
        }
    }
    for (const auto &[from, to] : places) {
        QTextCursor cursor(document());
        cursor.setPosition(from);
        cursor.setPosition(to, QTextCursor::KeepAnchor);
        cursor.mergeCharFormat(code);
    }
}

/// Drawings are as wide as the page.
void HelpBrowser::resizeEvent(QResizeEvent *event)
{
    QTextBrowser::resizeEvent(event);
    if (event->size().width() == event->oldSize().width() || m_topic.isEmpty())
        return;
    m_resized.start(); // the page is being laid out now, which a new text would pull away from under it
}

void HelpBrowser::refill()
{
    const int place = verticalScrollBar()->value();
    fill();
    verticalScrollBar()->setValue(place);
}

void HelpBrowser::follow(const QUrl &link)
{
    if (!link.isRelative()) {
        QDesktopServices::openUrl(link);
        return;
    }
    const QString path = QUrl(QStringLiteral("qrc") + pathOf(m_topic)).resolved(link).path();
    const QString topic = path.mid(path.indexOf(QLatin1String("/help/")) + 6).section(QLatin1Char('.'), 0, 0);
    if (showPage(topic))
        Q_EMIT pageShown(topic);
}

QVariant HelpBrowser::loadResource(int type, const QUrl &name)
{
    const QUrl whole = name.isRelative() ? document()->baseUrl().resolved(name) : name;
    const QString path = QLatin1Char(':') + whole.path();
    if (type == QTextDocument::ImageResource && path.endsWith(QLatin1String(".svg")))
        return drawing(path);
    return QTextBrowser::loadResource(type, name);
}

/// Drawings have the light colours of the design; each stands for one of the theme's.
QImage HelpBrowser::drawing(const QString &path) const
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QByteArray svg = file.readAll();
    const Theme &theme = m_theme.theme();
    const std::pair<const char *, QColor> colors[]
        = {{"#171C22", theme.text}, {"#47525E", theme.dim}, {"#7D8894", theme.outline}, {"#3D49C4", theme.accent},
            {"#8F0F22", theme.danger}, {"#FFFFFF", theme.canvas}, {"#F2F4F7", theme.window}};
    for (std::size_t i = 0; i < std::size(colors); ++i) // first to marks: two themes may swap colours
        svg.replace(colors[i].first, "@" + QByteArray::number(static_cast<int>(i)) + "@");
    for (std::size_t i = 0; i < std::size(colors); ++i)
        svg.replace("@" + QByteArray::number(static_cast<int>(i)) + "@", colors[i].second.name().toLatin1());
    QSvgRenderer renderer(svg);
    const double wish = theme.bodyPointSize / designPoints;
    const double room = viewport()->width() - 2.0 * document()->documentMargin();
    const double natural = std::max(1.0, renderer.defaultSize().width() * 1.0);
    const double scale = std::clamp(room / natural, 0.25, wish);
    QImage image((QSizeF(renderer.defaultSize()) * scale * devicePixelRatioF()).toSize(), QImage::Format_ARGB32);
    image.setDevicePixelRatio(devicePixelRatioF());
    image.fill(theme.canvas);
    QPainter painter(&image);
    renderer.render(&painter, QRectF(QPointF(), QSizeF(renderer.defaultSize()) * scale));
    return image;
}

} // namespace mb
