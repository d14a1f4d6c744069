// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/filechoice.h"

#include <QFileDialog>
#include <QRegularExpression>

#include <utility>

namespace mb {
namespace {

void open(QFileDialog &dialog, FileChosen chosen)
{
    dialog.setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(&dialog, &QFileDialog::fileSelected, &dialog, std::move(chosen));
    dialog.open();
}

QString endingOf(const QString &filter)
{
    return QRegularExpression(QStringLiteral("\\*\\.(\\w+)")).match(filter).captured(1);
}

} // namespace

void askForFile(QWidget &parent, const QString &title, const QString &filters, const QString &start, FileChosen chosen)
{
    auto *dialog = new QFileDialog(&parent, title, start, filters);
    dialog->setFileMode(QFileDialog::ExistingFile);
    open(*dialog, std::move(chosen));
}

void askForFolder(QWidget &parent, const QString &title, const QString &start, FileChosen chosen)
{
    auto *dialog = new QFileDialog(&parent, title, start);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    open(*dialog, std::move(chosen));
}

void askWhereToSave(
    QWidget &parent, const QString &title, const QString &filters, const QString &start, FileChosen chosen)
{
    auto *dialog = new QFileDialog(&parent, title, start, filters);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(endingOf(filters));
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog,
        [dialog](const QString &filter) { dialog->setDefaultSuffix(endingOf(filter)); });
    open(*dialog, std::move(chosen));
}

} // namespace mb
