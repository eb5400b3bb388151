# Debian's packages only. VTK comes first: it decides which major version of Qt the program is built with.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Ceres REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(SQLiteCpp REQUIRED)
find_package(VTK 9.1 REQUIRED COMPONENTS GUISupportQt ViewsContext2D ChartsCore RenderingContextOpenGL2
             RenderingOpenGL2 RenderingFreeType RenderingAnnotation InteractionStyle InteractionWidgets
             FiltersSources FiltersGeneral IOImage)
set(NINELINE_QT_VERSION ${VTK_QT_VERSION})
find_package(Qt${NINELINE_QT_VERSION} REQUIRED COMPONENTS Core Gui Widgets PrintSupport Svg LinguistTools Test)
if(NINELINE_BUILD_TESTS)
  find_package(GTest REQUIRED)
  find_package(benchmark REQUIRED)
endif()
