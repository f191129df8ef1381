"""It answers a request twice."""

import honest


class Broken(honest.Program):
    def on_read(self, request):
        super().on_read(request)
        super().on_read(request)


Broken().run()
