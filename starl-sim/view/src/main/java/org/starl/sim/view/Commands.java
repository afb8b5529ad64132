package org.starl.sim.view;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.sim.record.Part;
import org.starl.sim.replay.Mark;

/** All that can be asked for by key; menus, buttons and the help sheet are made from it. */
final class Commands {

  private static final String TIME = "Time";
  private static final String FLOOR = "Floor";
  private static final String ROBOTS = "Robots";
  private static final String PICTURE = "Picture";
  private static final String WINDOW = "Window";

  private static final long STEP_NS = 100_000_000;
  private static final long LONG_STEP_NS = 1_000_000_000;
  private static final double ZOOM = 1.25;
  private static final double PAN_PX = 60;

  /** The commands that only the window can execute. */
  interface Owner {
    void sendPoint();

    void injectFault();

    void turnInspector();

    void switchTheme();

    void savePicture();

    void help();

    void close();
  }

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

  Commands(Session session, Owner owner) {
    this.session = session;
    Playback playback = session.playback();
    play = add(TIME, "Play or pause", "Play on from here, or stop", "SPACE", "space", this::toggle);
    on = time("Step forwards", "On by 100 ms", "RIGHT", "\u2192", STEP_NS);
    back = time("Step backwards", "Back by 100 ms", "LEFT", "\u2190", -STEP_NS);
    time("Long step forwards", "On by a second", "shift RIGHT", "shift \u2192", LONG_STEP_NS);
    time("Long step backwards", "Back by a second", "shift LEFT", "shift \u2190", -LONG_STEP_NS);
    event =
        add(TIME, "Next event", "To the next event", "PERIOD", ".", () -> playback.stepEvents(1));
    eventBack =
        add(
            TIME,
            "Event before",
            "To the event before",
            "COMMA",
            ",",
            () -> playback.stepEvents(-1));
    first = add(TIME, "Beginning", "To the beginning", "HOME", "home", () -> playback.seek(0));
    last = add(TIME, "End", "To the end so far", "END", "end", playback::seekEnd);
    add(TIME, "Faster", "To the next higher speed", "UP", "\u2191", playback::faster);
    add(TIME, "Slower", "To the next lower speed", "DOWN", "\u2193", playback::slower);
    add(
        TIME,
        "No limit",
        "As fast as it goes",
        "M",
        "M",
        () -> playback.setSpeed(Playback.NO_LIMIT));
    violationAfter = mark("Next violation", "N", "N", true, Mark.Kind.VIOLATION);
    violationBefore = mark("Violation before", "P", "P", false, Mark.Kind.VIOLATION);
    mark("Next mark of any kind", "shift N", "shift N", true, null);
    mark("Mark of any kind before", "shift P", "shift P", false, null);
    ViewState view = session.view();
    add(FLOOR, "Fit", "Show all of the floor", "F", "F", view::fit);
    zoom("Zoom in", "typed +", "+", ZOOM);
    zoom("Zoom out", "typed -", "-", 1 / ZOOM);
    pan("Look left", "control LEFT", "control \u2190", PAN_PX, 0);
    pan("Look right", "control RIGHT", "control \u2192", -PAN_PX, 0);
    pan("Look up", "control UP", "control \u2191", 0, PAN_PX);
    pan("Look down", "control DOWN", "control \u2193", 0, -PAN_PX);
    robots(owner);
    switches();
    add(PICTURE, "Dark or light", "Change the theme", "D", "D", owner::switchTheme);
    add(
        WINDOW,
        "Save picture\u2026",
        "Write what is shown to a PNG file",
        "control S",
        "control S",
        owner::savePicture);
    help =
        add(WINDOW, "Keys and marks", "What keys do and marks mean", "F1", "F1 or ?", owner::help);
    add(
        WINDOW,
        "Close",
        "End the run, if it goes on, and close",
        "control Q",
        "control Q",
        owner::close);
  }

  private void robots(Owner owner) {
    ViewState view = session.view();
    add(
        ROBOTS,
        "Next robot",
        "Select the next robot",
        "TAB",
        "tab",
        () -> view.selectNeighbour(session.scene(), true));
    add(
        ROBOTS,
        "Robot before",
        "Select the robot before",
        "shift TAB",
        "shift tab",
        () -> view.selectNeighbour(session.scene(), false));
    add(ROBOTS, "Nobody", "Select nobody", "ESCAPE", "escape", () -> view.select(null));
    add(
        ROBOTS,
        "Follow",
        "Keep the selected robot in the middle, or no longer",
        "C",
        "C",
        () -> view.follow(!view.isFollowing()));
    add(
        ROBOTS,
        "State, messages, log",
        "Turn to the inspector's next page",
        "I",
        "I",
        owner::turnInspector);
    add(
        ROBOTS,
        "Inject a fault\u2026",
        "Let something go wrong from now on; recorded as an event",
        "X",
        "X",
        owner::injectFault);
    add(
        ROBOTS,
        "Send a point\u2026",
        "Show the selected robot's app a place; recorded as an event",
        "G",
        "G",
        owner::sendPoint);
  }

  private void switches() {
    ViewState view = session.view();
    for (Part part : Part.values()) {
      String key = key(part);
      add(
          PICTURE,
          part.title(),
          "Show " + part.meaning() + ", or hide it",
          key,
          key,
          () -> view.show(part, !view.shows(part)));
    }
    List<String> parts = session.playback().layer().parts();
    for (int i = 0; i < Math.min(9, parts.size()); i++) {
      String part = parts.get(i);
      String digit = Integer.toString(i + 1);
      add(
          PICTURE,
          "The app's " + part,
          "Show the app's " + part + ", or hide them",
          "control " + digit,
          "control " + digit,
          () -> view.show(part, !view.look().shows(part)));
    }
    add(
        PICTURE,
        "Messages of the selected robot only",
        "Hide messages between others, or show them",
        "O",
        "O",
        () -> session.traffic().onlyOfSelected(!session.traffic().isOfSelectedOnly()));
  }

  /** A digit: 1 to 9, and 0 for the tenth. */
  static String key(Part part) {
    return Integer.toString((part.ordinal() + 1) % 10);
  }

  private Command add(
      String group, String name, String meaning, String key, String shown, Runnable does) {
    Command command = new Command(group, name, meaning, key, shown, does);
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

  private Command time(String name, String meaning, String key, String shown, long byNs) {
    return add(TIME, name, meaning, key, shown, () -> session.playback().stepTime(byNs));
  }

  private Command mark(
      String name, String key, String shown, boolean isAfter, Mark.@Nullable Kind kind) {
    String what = kind == null ? "mark on the timeline" : "violation";
    String meaning = isAfter ? "To the next " + what : "To the " + what + " before";
    return add(
        TIME,
        name,
        meaning,
        key,
        shown,
        () -> {
          Mark mark = session.playback().neighbour(isAfter, kind);
          if (mark != null) {
            session.playback().toMark(mark);
          }
        });
  }

  private void zoom(String name, String key, String shown, double factor) {
    ViewState view = session.view();
    add(
        FLOOR,
        name,
        name,
        key,
        shown,
        () -> {
          var at = view.viewport();
          view.zoom(factor, at.widthPx() / 2.0, at.heightPx() / 2.0);
        });
  }

  private void pan(String name, String key, String shown, double rightPx, double downPx) {
    add(FLOOR, name, name, key, shown, () -> session.view().pan(rightPx, downPx));
  }

  /** In the order to show them. */
  List<Command> all() {
    return List.copyOf(all);
  }

  List<Command> of(String group) {
    return all.stream().filter(command -> command.group().equals(group)).toList();
  }

  /** In the order to show them. */
  static List<String> groups() {
    return List.of(TIME, FLOOR, ROBOTS, PICTURE, WINDOW);
  }
}
