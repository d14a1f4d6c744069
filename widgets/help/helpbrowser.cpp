// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/helpbrowser.h"

#include "widgets/help/helpdrawing.h"
#include "widgets/help/helppages.h"

#include <QAbstractTextDocumentLayout>
#include <QApplication>
#include <QDesktopServices>
#include <QFile>
#include <QFontDatabase>
#include <QImage>
#include <QPainter>
#include <QPointer>
#include <QRegularExpression>
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

/// Of a heading, as a link to it names it: "#where-it-stays-behind".
QString anchorOf(const QString &heading)
{
    QString anchor = heading.toLower();
    anchor.remove(QRegularExpression(QStringLiteral("[^\\w -]"), QRegularExpression::UseUnicodePropertiesOption));
    return anchor.replace(QLatin1Char(' '), QLatin1Char('-'));
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
    connect(this, &QTextBrowser::anchorClicked, this, &HelpBrowser::follow);
    connect(&theme, &ThemeSource::changed, this, &HelpBrowser::fill);
    m_resized.setSingleShot(true);
    connect(&m_resized, &QTimer::timeout, this, &HelpBrowser::refill);
}

bool HelpBrowser::showPage(const QString &topic)
{
    const QString file = helpFile(topic);
    if (!QFile::exists(file))
        return false;
    open(file);
    return true;
}

QString HelpBrowser::topic() const
{
    return m_file.isEmpty() ? QString() : helpTopicOf(m_file);
}

void HelpBrowser::open(const QString &file)
{
    m_file = file;
    fill();
    verticalScrollBar()->setValue(0);
}

/// Into a document of its own, which is laid out once it is whole and not after each piece; with the one before it go the drawings of
/// another theme, which are kept by their name.
void HelpBrowser::fill()
{
    QFile file(m_file);
    if (!file.open(QIODevice::ReadOnly))
        return;
    auto *page = new QTextDocument(this);
    page->setUndoRedoEnabled(false);
    page->setDefaultFont(font());
    page->setDocumentMargin(m_theme.theme().u(16));
    page->setBaseUrl(QUrl(QStringLiteral("qrc") + m_file));
    page->setMarkdown(QString::fromUtf8(file.readAll()), QTextDocument::MarkdownDialectGitHub);
    dressTables(*page);
    dressCode(*page);
    const QPointer<QTextDocument> before = document();
    setDocument(page);
    if (before) // the editor has deleted its first one itself; a link in this one may just be followed
        before->deleteLater();
    moveCursor(QTextCursor::Start);
}

/// As the tables of the program: lines between the rows, room around the words.
void HelpBrowser::dressTables(QTextDocument &page) const
{
    const Theme &theme = m_theme.theme();
    for (QTextFrame *frame : page.rootFrame()->childFrames()) {
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
void HelpBrowser::dressCode(QTextDocument &page)
{
    QTextCharFormat code;
    code.setFontFamily(QFontDatabase::systemFont(QFontDatabase::FixedFont).family());
    std::vector<std::pair<int, int>> places;
    for (QTextBlock block = page.begin(); block.isValid(); block = block.next()) {
        for (auto part = block.begin(); !part.atEnd(); ++part) {
            const QTextFragment words = part.fragment();
            if (words.charFormat().fontFixedPitch())
                places.emplace_back(words.position(), words.position() + words.length());
        }
    }
    for (const auto &[from, to] : places) {
        QTextCursor cursor(&page);
        cursor.setPosition(from);
        cursor.setPosition(to, QTextCursor::KeepAnchor);
        cursor.mergeCharFormat(code);
    }
}

/// Drawings are as wide as the page.
void HelpBrowser::resizeEvent(QResizeEvent *event)
{
    QTextBrowser::resizeEvent(event);
    if (event->size().width() == event->oldSize().width() || m_file.isEmpty())
        return;
    m_resized.start(); // the page is being laid out now, which a new text would pull away from under it
}

void HelpBrowser::refill()
{
    const int place = verticalScrollBar()->value();
    fill();
    verticalScrollBar()->setValue(place);
}

/// The page in the language of the window has another place by now.
void HelpBrowser::changeEvent(QEvent *event)
{
    QTextBrowser::changeEvent(event);
    if (event->type() != QEvent::LanguageChange || m_file.isEmpty())
        return;
    setAccessibleName(tr("Help"));
    open(helpFile(topic()));
}

void HelpBrowser::follow(const QUrl &link)
{
    if (!link.isRelative()) {
        QDesktopServices::openUrl(link);
        return;
    }
    const QUrl whole = document()->baseUrl().resolved(link);
    const QString file = QLatin1Char(':') + whole.path();
    if (!file.endsWith(QLatin1String(".md")) || !QFile::exists(file))
        return;
    open(helpFile(helpTopicOf(file))); // an English page knows of English ones only
    if (whole.hasFragment())
        goToHeading(whole.fragment());
    Q_EMIT pageShown(topic());
}

void HelpBrowser::goToHeading(const QString &anchor)
{
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 0 || anchorOf(block.text()) != anchor)
            continue;
        setTextCursor(QTextCursor(block));
        verticalScrollBar()->setValue(static_cast<int>(document()->documentLayout()->blockBoundingRect(block).top()));
        return;
    }
}

QVariant HelpBrowser::loadResource(int type, const QUrl &name)
{
    const QUrl whole = name.isRelative() ? document()->baseUrl().resolved(name) : name;
    const QString path = QLatin1Char(':') + whole.path();
    if (type == QTextDocument::ImageResource && path.endsWith(QLatin1String(".svg")))
        return drawing(path);
    if (type == QTextDocument::ImageResource && path.startsWith(QLatin1String(":/help/")))
        return picture(path);
    return QTextBrowser::loadResource(type, name);
}

double HelpBrowser::room() const
{
    return viewport()->width() - 2.0 * document()->documentMargin();
}

QImage HelpBrowser::drawing(const QString &path) const
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const Theme &theme = m_theme.theme();
    QSvgRenderer renderer(dressedDrawing(file.readAll(), theme, QApplication::font()));
    const double wish = theme.bodyPointSize / designPoints;
    const double natural = std::max(1.0, renderer.defaultSize().width() * 1.0);
    const double scale = std::clamp(room() / natural, 0.25, wish);
    QImage image((QSizeF(renderer.defaultSize()) * scale * devicePixelRatioF()).toSize(), QImage::Format_ARGB32);
    image.setDevicePixelRatio(devicePixelRatioF());
    image.fill(theme.canvas);
    QPainter painter(&image);
    renderer.render(&painter, QRectF(QPointF(), QSizeF(renderer.defaultSize()) * scale));
    return image;
}

/// No wider than the page.
QImage HelpBrowser::picture(const QString &path) const
{
    const QImage image(path);
    const int width = static_cast<int>(std::max(1.0, room()) * devicePixelRatioF());
    if (image.width() <= width)
        return image;
    QImage small = image.scaledToWidth(width, Qt::SmoothTransformation);
    small.setDevicePixelRatio(devicePixelRatioF());
    return small;
}

} // namespace mb
