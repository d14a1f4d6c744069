// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/queuehead.h"

#include "widgets/common/captioned.h"
#include "widgets/common/iconbutton.h"
#include "widgets/firmware/queuerecipe.h"
#include "widgets/service/recipetext.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>

namespace mb {

QueueHead::QueueHead(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    auto *row = new QHBoxLayout(this);
    const int edge = theme.theme().u(10);
    row->setContentsMargins(theme.theme().u(16), edge, theme.theme().u(16), edge);
    row->setSpacing(theme.theme().u(16));
    m_name = addCaptioned(theme, tr("recipe"), TextRole::Emphasis, *row, 2, this);
    m_image = addCaptioned(theme, tr("image"), TextRole::Body, *row, 3, this);
    m_parameters = addCaptioned(theme, tr("parameters"), TextRole::Body, *row, 2, this);
    m_number = addCaptioned(theme, tr("number rule"), TextRole::Body, *row, 1, this);
    auto *image = new CommandButton(m_theme, Symbol::Folder, tr("Open image…"), this);
    auto *recipe = new CommandButton(m_theme, Symbol::Open, tr("Open recipe…"), this);
    row->addWidget(m_openImage = image);
    row->addWidget(m_openRecipe = recipe);
    row->addWidget(m_edit = new IconButton(m_theme, Symbol::Edit, tr("Write a recipe"), this));
    connect(static_cast<IconButton *>(m_edit), &QToolButton::clicked, this, &QueueHead::editWanted);
    connect(image, &QPushButton::clicked, this, &QueueHead::askImage);
    connect(recipe, &QPushButton::clicked, this, &QueueHead::askRecipe);
}

void QueueHead::show(const QueueRecipe &recipe)
{
    const service::RecipeMatter *matter = recipe.matter().get();
    m_name->setText(matter ? recipeName(matter) : tr("none yet"));
    m_image->setText(imageText(matter));
    m_parameters->setText(parameterText(matter));
    m_number->setText(numberText(matter));
}

void QueueHead::setChoosing(bool on)
{
    m_openImage->setEnabled(on);
    m_openRecipe->setEnabled(on);
    m_edit->setEnabled(on);
}

void QueueHead::askImage()
{
    auto *dialog
        = new QFileDialog(this, tr("Open a firmware image"), QString(), tr("Intel HEX (*.hex *.ihex);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &QueueHead::imageChosen);
    dialog->open();
}

void QueueHead::askRecipe()
{
    auto *dialog = new QFileDialog(this, tr("Open recipe"), QString(), tr("Recipes (*.json);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &QueueHead::recipeChosen);
    dialog->open();
}

} // namespace mb
