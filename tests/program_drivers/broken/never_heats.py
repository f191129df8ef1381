"""It says ok to heat, and its heat stays off."""

import honest


class Broken(honest.Program):
    def on_heat(self, request):
        super().on_heat(request)
        self.device.heating = False


Broken().run()
