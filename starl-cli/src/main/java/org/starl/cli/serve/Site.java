package org.starl.cli.serve;

import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.sim.replay.Recording;
import org.starl.sim.view.page.LivePage;

/** What a {@link PageServer} shows. Its methods may be called on several threads at once. */
public interface Site {

  /** The kind of the first page. */
  enum Home {
    /** The run {@code 1}. */
    RUN,
    CAMPAIGN,
    PLAYGROUND
  }

  /**
   * A run, live or recorded.
   *
   * @param title for people: its app and seed
   * @param command the command line that makes it; empty if there is none
   */
  record Shown(String title, String command, Recording recording, LivePage page) {}

  Home home();

  /** The run of this number, which {@link #start} gave; null if there is none, or it is gone. */
  @Nullable Shown run(int number);

  /** The runs that there are, and the campaign, as JSON. */
  Map<String, Object> overview();

  /** The apps, their parameters, the settings and the faults, as a JSON schema. */
  Map<String, Object> schema();

  /**
   * Starts a run.
   *
   * @param request {@code app}, {@code seed}, {@code set}: settings and parameters by key, {@code
   *     faults}: a list of texts
   * @return its number
   * @throws org.starl.input.BadInput if the request is wrong, or this site starts no runs
   */
  int start(Map<String, ?> request);
}
