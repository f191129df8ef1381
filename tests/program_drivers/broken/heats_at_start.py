"""Its heat is always on."""

import honest


class Broken(honest.Program):
    def state(self):
        self.device.heating = True
        return super().state()


Broken().run()
