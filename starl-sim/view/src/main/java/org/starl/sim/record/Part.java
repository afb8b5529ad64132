package org.starl.sim.record;

/** The parts of a picture; the user can hide each of them. */
public enum Part {
  APP("App", "the app's drawing: zones, routes, goals"),
  WALLS("Obstacles", "obstacles that all robots know"),
  HIDDEN("Hidden obstacles", "obstacles on no robot's map at the start"),
  TRAILS("Trails", "trails of the robots"),
  ROBOTS("Robots", "robots at their true positions, with their headings"),
  NAMES("Names", "names of the robots, where there is room"),
  LOCATIONS("Locations", "each robot's location in its program, where there is room"),
  BUMPS("Bumps", "points where a robot bumped into something, for 10 s"),
  RANGE("Radio range", "the range of the radio, if a fault limits it"),
  MESSAGES("Messages", "messages in transit"),
  BELIEFS("Beliefs", "where a robot believes to be, with its error bound, if that is visible");

  private final String title;
  private final String meaning;

  Part(String title, String meaning) {
    this.title = title;
    this.meaning = meaning;
  }

  /** The name of the part, for a check box. */
  public String title() {
    return title;
  }

  /** A description that follows "show", for a tooltip. */
  public String meaning() {
    return meaning;
  }
}
