"""Starts the program on an X server of its own and drives it with a real pointer (xdotool).

Nothing waits for a fixed time: the program writes its state to a file whenever it comes to rest
(--status-file), and every step waits until that state shows its effect.
"""

import ctypes
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import time

PATIENCE = float(os.environ.get("LIMN_E2E_PATIENCE", "120"))  # Seconds for any one effect.


class Display:
    """An Xvfb on the first free display number; at 192 dots an inch everything is twice as large."""

    def __init__(self, size=(1280, 800), dots_per_inch=None):
        read_end, write_end = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{size[0]}x{size[1]}x24",
             "-nolisten", "tcp"],
            pass_fds=[write_end], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise RuntimeError("Xvfb did not start")
        self.name = f":{number}"
        if dots_per_inch:
            self.connection = set_resources(self.name, f"Xft.dpi:\t{dots_per_inch}\n".encode())

    def close(self):
        self.process.terminate()
        self.process.wait()


class Program:
    """One run of the program, with folders and preferences of its own."""

    def __init__(self, executable, arguments, display, folder, environment=None,
                 is_first_start=False):
        self.folder = folder
        self.pictures = os.path.join(folder, "pictures")
        os.makedirs(self.pictures, exist_ok=True)
        self.status_path = os.path.join(folder, "status.json")
        if os.path.exists(self.status_path):
            os.remove(self.status_path)
        self.environment = clean_environment(folder)
        self.environment["DISPLAY"] = display.name
        self.environment["XDG_PICTURES_DIR"] = self.pictures
        self.environment.update(environment or {})
        if not is_first_start:
            forget_hints(self.environment["XDG_CONFIG_HOME"])
        self.log_path = os.path.join(folder, "log.txt")
        with open(self.log_path, "wb") as log:
            self.process = subprocess.Popen(
                [executable, *arguments, "--status-file", self.status_path],
                env=self.environment, stdout=log, stderr=log, cwd=folder)
        self.state = None

    # Reading

    def log(self):
        with open(self.log_path, errors="replace") as log:
            return log.read()

    def read(self):
        if self.process.poll() is not None:
            raise AssertionError(f"the program ended with {self.process.returncode}:\n{self.log()}")
        try:
            with open(self.status_path) as file:
                self.state = json.load(file)
        except FileNotFoundError:
            self.state = None
        return self.state

    def wait_for(self, what, condition):
        """Waits until condition(state) holds and returns the state."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            state = self.read()
            if state is not None and condition(state):
                return state
            time.sleep(0.05)
        shown = {k: v for k, v in (self.state or {}).items() if k not in ("items", "depths")}
        raise AssertionError(f"waited in vain until {what}; the state is {shown}\n{self.log()}")

    def wait_for_rest(self):
        """Waits until the camera glides no more."""
        view, since = None, time.monotonic()
        while time.monotonic() - since < 0.4:
            time.sleep(0.05)
            state = self.wait_for("it is at rest", lambda s: not s["busy"])
            if state["view"] != view:
                view, since = state["view"], time.monotonic()
        return self.state

    def wait_for_exit(self):
        try:
            return self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired as error:
            raise AssertionError("the program did not end") from error

    def kill(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGKILL)
            self.process.wait()

    # Acting

    def xdotool(self, *arguments):
        subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, check=True)

    def key(self, *keys):
        self.xdotool("key", "--clearmodifiers", *keys)

    def type(self, text):
        self.xdotool("type", "--delay", "20", text)

    def move(self, x, y):
        self.xdotool("mousemove", round(x), round(y))

    def drag(self, places, button=1, held=None):
        """Presses at the first place, passes the others, releases at the last."""
        self.move(*places[0])
        if held:
            self.xdotool("keydown", held)
        self.xdotool("mousedown", button)
        for place in places[1:]:
            self.move(*place)
        self.xdotool("mouseup", button)
        if held:
            self.xdotool("keyup", held)

    def click(self, x, y):
        self.drag([(x, y)])

    def item(self, name):
        """The middle of the control whose name begins like this."""
        found = [rect for key, rect in self.state["items"].items() if key.startswith(name)]
        assert len(found) == 1, f"{len(found)} controls are called {name}"
        x, y, width, height = found[0]
        return x + width / 2, y + height / 2

    def take_picture(self, path):
        """The window as it is, the first picture of this run, as a file of its own."""
        self.key("F12")
        self.wait_for("the picture is taken", lambda _: os.listdir(self.pictures))
        shutil.copyfile(os.path.join(self.pictures, os.listdir(self.pictures)[0]), path)

    def window(self):
        return subprocess.run(["xdotool", "search", "--class", "^Limn$"], env=self.environment,
                              check=True, capture_output=True, text=True).stdout.split()[-1]

    def resize(self, width, height):
        self.xdotool("windowsize", self.window(), width, height)

    def close_window(self):
        """Asks the window to close, as a window manager does."""
        send_delete_window(self.environment["DISPLAY"], int(self.window()))


def check_replay(executable, recording, folder):
    """What was recorded gives the same documents and pictures without a window."""
    run = subprocess.run([executable, "replay", recording, "--json"], env=clean_environment(folder),
                         capture_output=True, text=True, timeout=PATIENCE)
    assert run.returncode == 0, run.stderr
    assert "Sanitizer" not in run.stderr, run.stderr
    played = json.loads(run.stdout)
    assert played["is_whole"] and played["actions"] > 0, played
    assert played["documents_compared"] > 5 and played["pictures_compared"] > 0, played


def forget_hints(config):
    """Someone has been here before, who needs no hints and chose nothing."""
    kept = os.path.join(config, "limn", "preferences.json")
    if not os.path.exists(kept):
        os.makedirs(os.path.dirname(kept), exist_ok=True)
        with open(kept, "w") as file:
            json.dump({"hints": False}, file)


def clean_environment(folder):
    """This process's environment without a display and without the person's own preferences."""
    kept = {k: v for k, v in os.environ.items()
            if k not in ("DISPLAY", "WAYLAND_DISPLAY") and not k.startswith("XDG_")}
    kept.update(HOME=folder, XDG_CONFIG_HOME=os.path.join(folder, "config"),
                LIBGL_ALWAYS_SOFTWARE="1", LIMN_DIALOGS="own")
    return kept


class ClientMessage(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("window", ctypes.c_ulong),
                ("message_type", ctypes.c_ulong), ("format", ctypes.c_int),
                ("data", ctypes.c_long * 5), ("padding", ctypes.c_long * 12)]


def set_resources(display_name, text):
    """What xrdb does; the connection returned keeps the server from forgetting it."""
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XOpenDisplay.argtypes = [ctypes.c_char_p]
    x11.XDefaultRootWindow.restype = ctypes.c_ulong
    x11.XDefaultRootWindow.argtypes = [ctypes.c_void_p]
    x11.XChangeProperty.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_ulong, ctypes.c_ulong,
                                    ctypes.c_int, ctypes.c_int, ctypes.c_char_p, ctypes.c_int]
    x11.XSync.argtypes = [ctypes.c_void_p, ctypes.c_int]
    display = x11.XOpenDisplay(display_name.encode())
    resource_manager, string, replace = 23, 31, 0
    x11.XChangeProperty(display, x11.XDefaultRootWindow(display), resource_manager, string, 8,
                        replace, text, len(text))
    x11.XSync(display, 0)
    return display


def send_delete_window(display_name, window):
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XInternAtom.restype = ctypes.c_ulong
    x11.XInternAtom.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int]
    x11.XSendEvent.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_long,
                               ctypes.c_void_p]
    x11.XCloseDisplay.argtypes = [ctypes.c_void_p]
    display = x11.XOpenDisplay(display_name.encode())
    message = ClientMessage()
    message.type = 33  # ClientMessage
    message.window = window
    message.message_type = x11.XInternAtom(display, b"WM_PROTOCOLS", 0)
    message.format = 32
    message.data[0] = x11.XInternAtom(display, b"WM_DELETE_WINDOW", 0)
    x11.XSendEvent(display, window, 0, 0, ctypes.byref(message))
    x11.XCloseDisplay(display)


class Folder:
    """A temporary folder that goes when it is left, unless something failed."""

    def __enter__(self):
        self.path = tempfile.mkdtemp(prefix="limn-e2e-")
        return self.path

    def __exit__(self, kind, *_):
        if kind is None:
            shutil.rmtree(self.path, ignore_errors=True)
        else:
            print(f"what is left of the run lies in {self.path}")


def count_in(name):
    """The number of faces in an undo name such as "paint 12 faces"."""
    found = re.search(r"(\d+) face", name)
    return int(found.group(1)) if found else 0
