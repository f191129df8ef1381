// The baseline of start_benchmark: what Qt's core alone costs.

#include <QCoreApplication>

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    return 0;
}
