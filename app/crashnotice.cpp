// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/crashnotice.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/stateglyph.h"

#include <QClipboard>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QGuiApplication>
#include <QPlainTextEdit>

#include <algorithm>

namespace mb {

CrashNotice::CrashNotice(const QString &words, const QString &report, const ThemeSource &theme, QWidget *parent)
    : QFrame(parent)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("crashNotice"));
    setAccessibleName(tr("The program ended unexpectedly"));
    setStyleProperty(*this, "banner", QStringLiteral("caution"));
    auto *row = layoutIn<QHBoxLayout>(
        this, theme.theme().u(12), {theme.theme().u(12), theme.theme().u(6), theme.theme().u(12), theme.theme().u(6)});
    row->addWidget(new StateGlyph(theme, GlyphState::Warning, this));
    auto *text = textLabel(words, TextRole::Body, Tone::Text, this);
    text->setWordWrap(true);
    row->addWidget(text, 1);
    auto *restore = new CommandButton(theme, tr("Open it again"), this);
    restore->setPrimary(true);
    auto *read = new CommandButton(theme, tr("Read the report"), this);
    read->setVisible(!report.isEmpty());
    auto *dismiss = new CommandButton(theme, tr("Dismiss"), this);
    for (QPushButton *button : {restore, read, dismiss})
        row->addWidget(button);
    connect(restore, &QPushButton::clicked, this, &CrashNotice::restoreWanted);
    connect(restore, &QPushButton::clicked, this, &CrashNotice::dismissed);
    connect(read, &QPushButton::clicked, this, [this, report] { showReport(report); });
    connect(dismiss, &QPushButton::clicked, this, &CrashNotice::dismissed);
    connect(this, &CrashNotice::dismissed, this, &QWidget::hide);
}

void CrashNotice::showReport(const QString &file)
{
    auto *dialog = new QDialog(this);
    dialog->setObjectName(QStringLiteral("crashReport"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Report of the crash"));
    auto *column = new QVBoxLayout(dialog);
    auto *where = textLabel(file, TextRole::Caption, Tone::Dim, dialog);
    where->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    where->setAccessibleName(tr("File of the report"));
    where->setWordWrap(true);
    QFile report(file);
    const QString words = report.open(QIODevice::ReadOnly) ? QString::fromUtf8(report.readAll()) : report.errorString();
    auto *text = new QPlainTextEdit(words, dialog);
    text->setReadOnly(true);
    text->setTabChangesFocus(true);
    text->setAccessibleName(tr("Report of the crash"));
    column->addWidget(where);
    column->addWidget(text, 1);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    const QPushButton *copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
    column->addWidget(buttons);
    connect(copy, &QPushButton::clicked, dialog, [words] { QGuiApplication::clipboard()->setText(words); });
    connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
    const QSize room = window()->size();
    dialog->resize(std::min(m_theme.theme().u(720), room.width() * 9 / 10),
        std::min(m_theme.theme().u(480), room.height() * 9 / 10));
    dialog->show();
}

} // namespace mb
