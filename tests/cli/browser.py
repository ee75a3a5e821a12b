"""Chromium without a window, driven through ChromeDriver's HTTP interface (W3C WebDriver)."""

import base64
import json
import shutil
import subprocess
import tempfile
import time
import urllib.error
import urllib.request

OPTIONS = [
    "--headless=new",
    "--no-sandbox",  # as root, in containers
    "--hide-scrollbars",
    "--use-gl=angle",
    "--use-angle=swiftshader",  # WebGL without a graphics card
    "--enable-unsafe-swiftshader",
    "--disable-dev-shm-usage",
]


class Browser:
    """One window; use it as a context."""

    def __init__(self, width=1280, height=1000):
        self.size = (width, height)

    def __enter__(self):
        self.profile = tempfile.mkdtemp(prefix="browser-")
        self.driver = subprocess.Popen(
            ["chromedriver", "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.base = f"http://127.0.0.1:{self._port()}"
        options = {"args": OPTIONS + [f"--user-data-dir={self.profile}"]}
        wanted = {"goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}
        session = self._call("POST", "/session", {"capabilities": {"alwaysMatch": wanted}})
        self.base += "/session/" + session["sessionId"]
        self.resize(*self.size)
        return self

    def __exit__(self, *_):
        try:
            self._call("DELETE", "")
        except (urllib.error.URLError, RuntimeError):
            pass  # it is ended below in any case
        self.driver.terminate()
        self.driver.wait()
        self.driver.stdout.close()
        shutil.rmtree(self.profile, ignore_errors=True)

    def _port(self):
        for line in self.driver.stdout:
            if "started successfully on port" in line:
                return int(line.rstrip().rstrip(".").split()[-1])
        raise RuntimeError("ChromeDriver did not start")

    def _call(self, method, path, content=None):
        request = urllib.request.Request(
            self.base + path,
            data=json.dumps(content or {}).encode() if method == "POST" else None,
            headers={"Content-Type": "application/json"},
            method=method)
        try:
            with urllib.request.urlopen(request, timeout=120) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(json.load(error)["value"]["message"]) from None

    def protocol(self, command, **arguments):
        """A command of Chromium's own protocol."""
        return self._call("POST", "/goog/cdp/execute", {"cmd": command, "params": arguments})

    def resize(self, width, height):
        self.protocol("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                      mobile=False)

    def colour_scheme(self, scheme):
        self.protocol("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])

    def open(self, file):
        self._call("POST", "/url", {"url": f"file://{file}"})

    def run(self, script, *arguments):
        """What a script returns, called with the arguments."""
        return self._call("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def wait_for(self, script, seconds=20):
        """Waits until a script returns something true, and returns it."""
        end = time.monotonic() + seconds
        while True:
            value = self.run(script)
            if value or time.monotonic() > end:
                return value
            time.sleep(0.1)

    def console(self):
        """What the pages logged, errors among it."""
        return self._call("POST", "/se/log", {"type": "browser"})

    def screenshot(self, file, clip=None):
        """A PNG of the window, or of a part of the page: x, y, width, height [pixels] and scale."""
        part = {"clip": clip, "captureBeyondViewport": True} if clip else {}
        with open(file, "wb") as image:
            image.write(base64.b64decode(self.protocol("Page.captureScreenshot", format="png", **part)["data"]))

    def pdf(self):
        """The page as printed on A4."""
        printed = self.protocol("Page.printToPDF", paperWidth=8.27, paperHeight=11.69, printBackground=True)
        return base64.b64decode(printed["data"])
