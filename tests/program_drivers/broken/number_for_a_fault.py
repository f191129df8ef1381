"""It tells a temperature below absolute zero for a sensor that is open, instead of null."""

import honest


class Broken(honest.Program):
    def state(self):
        return dict(super().state(), temperatures=[295.2, -999.0, 301.7])


Broken().run()
