#pragma once

#include <QString>

namespace nineline::shell {

class MainWindow;

/// Works the example through every page and writes one picture for each; for the documentation and for
/// looking at the window. Ends the application.
void takeScreenshots(MainWindow* window, const QString& folder);

}  // namespace nineline::shell
