"""While it homes its position changes, and it does not say that it moves."""

import honest


class Broken(honest.Program):
    homes = False

    def on_home(self, request):
        self.homes = True
        super().on_home(request)

    def state(self):
        return dict(super().state(), moving=self.device.moving() and not self.homes)


Broken().run()
