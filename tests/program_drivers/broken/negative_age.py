"""It tells an age below zero: a measurement of the future."""

import honest


class Broken(honest.Program):
    def state(self):
        return dict(super().state(), age=-0.2)


Broken().run()
