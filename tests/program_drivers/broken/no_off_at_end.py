"""It leaves the robot moving, or the heat on, at the end of its input; the next start finds it so."""

import honest


class Broken(honest.Program):
    def on_end(self):
        self.device.advance()


Broken().run()
