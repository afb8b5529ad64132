package org.starl.sim.record;

/** What a picture consists of besides the app's {@link Layer}; each can be switched off. */
public enum Part {
  APP("App", "what the app draws: zones, routes, goals"),
  WALLS("Obstacles", "what all robots know to be in the way"),
  HIDDEN("Hidden obstacles", "what is in the way and on no robot's map at the start"),
  TRAILS("Trails", "where bodies have been"),
  ROBOTS("Robots", "true bodies, with a line towards where they head"),
  NAMES("Names", "robots' names, where there is room"),
  LOCATIONS("Locations", "where each robot is in its program, where there is room"),
  BUMPS("Bumps", "where robots ran into something, for ten seconds"),
  RANGE("Radio range", "how far a datagram reaches, where the run limits it"),
  MESSAGES("Messages", "datagrams between sending and handling");

  private final String title;
  private final String meaning;

  Part(String title, String meaning) {
    this.title = title;
    this.meaning = meaning;
  }

  /** A word or two, for a switch. */
  public String title() {
    return title;
  }

  /** A line, for a tooltip. */
  public String meaning() {
    return meaning;
  }
}
