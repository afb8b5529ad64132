package org.starl.cli.report;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongFunction;

/**
 * What a campaign was of.
 *
 * @param app its name
 * @param summary the app in one line
 * @param command as it was given
 * @param seeds {@code 1..200}
 * @param faults that were asked for, each as text
 * @param given settings and parameters that were asked for, by key
 * @param settings all of them, by key
 * @param replay the command that runs one seed again
 */
public record Subject(
    String app,
    String summary,
    String command,
    String seeds,
    List<String> faults,
    Map<String, String> given,
    Map<String, String> settings,
    LongFunction<String> replay) {

  public Subject {
    faults = List.copyOf(faults);
    given = Collections.unmodifiableMap(new LinkedHashMap<>(given));
    settings = Collections.unmodifiableMap(new LinkedHashMap<>(settings));
  }
}
