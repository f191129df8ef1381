"""It tells degrees Celsius instead of kelvins."""

import honest


class Broken(honest.Program):
    def state(self):
        return dict(super().state(), temperatures=[22.05, None, 28.55])


Broken().run()
