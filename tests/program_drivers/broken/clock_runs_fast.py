"""Its clock runs fast, by half of the time that passes."""

import honest


class Broken(honest.Program):
    def clock(self):
        return 1.5 * super().clock()


Broken().run()
