"""A command for its second axis moves the third."""

import honest


class Broken(honest.Program):
    def on_velocity(self, request):
        rates = request.get("rates")
        if honest.finite_list(rates):
            request = dict(request, rates=[rates[0], rates[2], rates[1]])
        super().on_velocity(request)


Broken().run()
