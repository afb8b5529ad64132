package org.starl.sim.view;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.sim.record.Part;
import org.starl.sim.replay.Mark;
import org.starl.time.Time;

/** All commands with keys, for menus, buttons and the help sheet. */
final class Commands {

  private static final String TIME = "Time";
  private static final String FLOOR = "Floor";
  private static final String ROBOTS = "Robots";
  private static final String PICTURE = "Picture";
  private static final String WINDOW = "Window";

  private static final long STEP_NS = 100 * Time.NS_PER_MS;
  private static final long LONG_STEP_NS = Time.NS_PER_S;
  private static final double ZOOM = 1.25;
  private static final double PAN_PX = 60;

  private final Session session;
  private final List<Command> all = new ArrayList<>();

  final Command play;
  final Command first;
  final Command eventBack;
  final Command back;
  final Command on;
  final Command event;
  final Command last;
  final Command violationBefore;
  final Command violationAfter;
  final Command help;

  Commands(Session session, Content content) {
    this.session = session;
    Playback playback = session.playback();
    play = add(TIME, "Play or pause", "Play or pause", "SPACE", this::toggle);
    on = time("Step forward", "Forward 100 ms", "RIGHT", STEP_NS);
    back = time("Step back", "Back 100 ms", "LEFT", -STEP_NS);
    time("Long step forward", "Forward 1 s", "shift RIGHT", LONG_STEP_NS);
    time("Long step back", "Back 1 s", "shift LEFT", -LONG_STEP_NS);
    event = add(TIME, "Next event", "Next event", "PERIOD", () -> playback.stepEvents(1));
    eventBack =
        add(TIME, "Previous event", "Previous event", "COMMA", () -> playback.stepEvents(-1));
    first = add(TIME, "Start", "Go to the start", "HOME", () -> playback.seek(0));
    last =
        add(
            TIME,
            "End",
            "Go to the end, or to the latest time of a live run",
            "END",
            playback::seekEnd);
    add(TIME, "Faster", "Next higher speed", "UP", playback::faster);
    add(TIME, "Slower", "Next lower speed", "DOWN", playback::slower);
    add(TIME, "No limit", "As fast as possible", "M", () -> playback.setSpeed(Playback.NO_LIMIT));
    violationAfter = mark("Next violation", "N", true, Mark.Kind.VIOLATION);
    violationBefore = mark("Previous violation", "P", false, Mark.Kind.VIOLATION);
    mark("Next mark", "shift N", true, null);
    mark("Previous mark", "shift P", false, null);
    ViewState view = session.view();
    add(FLOOR, "Show all", "Show the whole floor", "F", view::fit);
    zoom("Zoom in", "typed +", ZOOM);
    zoom("Zoom out", "typed -", 1 / ZOOM);
    pan("Pan left", "control LEFT", PAN_PX, 0);
    pan("Pan right", "control RIGHT", -PAN_PX, 0);
    pan("Pan up", "control UP", 0, PAN_PX);
    pan("Pan down", "control DOWN", 0, -PAN_PX);
    robots(content);
    parts();
    String theme = "Switch between the dark and the light theme";
    add(PICTURE, "Dark or light", theme, "D", content::switchTheme);
    String save = "Save the floor as a PNG file";
    add(WINDOW, "Save picture\u2026", save, "control S", content::savePicture);
    help = add(WINDOW, "Keys and marks", "Explain keys and marks", "F1", content::showHelp);
    String close = "Close the window; a running simulation ends";
    add(WINDOW, "Close", close, "control Q", content::close);
  }

  private void robots(Content content) {
    ViewState view = session.view();
    select("Next robot", "Select the next robot", "TAB", true);
    select("Previous robot", "Select the previous robot", "shift TAB", false);
    add(ROBOTS, "Select none", "Clear the selection", "ESCAPE", () -> view.select(null));
    String follow = "Keep the selected robot in the centre, on or off";
    add(ROBOTS, "Follow", follow, "C", () -> view.follow(!view.isFollowing()));
    String pages = "Switch between state, messages and log";
    add(ROBOTS, "State, messages, log", pages, "I", content::turnInspector);
    String fault = "Inject a fault; the trace records it";
    add(ROBOTS, "Inject a fault\u2026", fault, "X", content::askFault);
    String point = "Send a point to the selected robot's app; the trace records it";
    add(ROBOTS, "Send a point\u2026", point, "G", content::askPoint);
  }

  private void parts() {
    ViewState view = session.view();
    for (Part part : Part.values()) {
      String meaning = "Show or hide " + part.meaning();
      add(PICTURE, part.title(), meaning, key(part), () -> view.show(part, !view.shows(part)));
    }
    List<String> parts = session.playback().layer().parts();
    for (int i = 0; i < Math.min(9, parts.size()); i++) {
      String part = parts.get(i);
      add(
          PICTURE,
          "The app's " + part,
          "Show or hide the app's " + part,
          "control " + (i + 1),
          () -> view.show(part, !view.look().shows(part)));
    }
    Traffic traffic = session.traffic();
    add(
        PICTURE,
        "Only messages of the selected robot",
        "Show or hide messages between other robots",
        "O",
        () -> traffic.onlyOfSelected(!traffic.isOfSelectedOnly()));
  }

  /** A digit: 1 to 9, and 0 for the tenth part; B for beliefs. */
  static String key(Part part) {
    return part == Part.BELIEFS ? "B" : Integer.toString((part.ordinal() + 1) % 10);
  }

  private Command add(String group, String name, String meaning, String key, Runnable action) {
    Command command = new Command(group, name, meaning, key, action);
    all.add(command);
    return command;
  }

  private void toggle() {
    if (session.playback().isPlaying()) {
      session.playback().pause();
    } else {
      session.playback().play();
    }
  }

  private Command time(String name, String meaning, String key, long byNs) {
    return add(TIME, name, meaning, key, () -> session.playback().stepTime(byNs));
  }

  private Command mark(String name, String key, boolean isAfter, Mark.@Nullable Kind kind) {
    String meaning = kind == null ? name + " on the timeline" : name;
    return add(
        TIME,
        name,
        meaning,
        key,
        () -> {
          Mark mark = session.playback().neighbour(isAfter, kind);
          if (mark != null) {
            session.playback().toMark(mark);
          }
        });
  }

  private void select(String name, String meaning, String key, boolean isNext) {
    ViewState view = session.view();
    add(ROBOTS, name, meaning, key, () -> view.selectNeighbour(session.scene(), isNext));
  }

  private void zoom(String name, String key, double factor) {
    ViewState view = session.view();
    add(
        FLOOR,
        name,
        name,
        key,
        () -> {
          var at = view.viewport();
          view.zoom(factor, at.widthPx() / 2.0, at.heightPx() / 2.0);
        });
  }

  private void pan(String name, String key, double rightPx, double downPx) {
    add(FLOOR, name, name, key, () -> session.view().pan(rightPx, downPx));
  }

  /** All commands in display order. */
  List<Command> all() {
    return List.copyOf(all);
  }

  List<Command> of(String group) {
    return all.stream().filter(command -> command.group().equals(group)).toList();
  }

  /** All groups in display order. */
  static List<String> groups() {
    return List.of(TIME, FLOOR, ROBOTS, PICTURE, WINDOW);
  }
}
