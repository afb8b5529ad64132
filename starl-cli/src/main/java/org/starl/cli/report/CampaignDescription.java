package org.starl.cli.report;

import java.util.List;
import java.util.Map;
import java.util.function.LongFunction;

/**
 * A campaign: its app, seeds and settings.
 *
 * @param app its name
 * @param summary the app in one line
 * @param command as the user typed it
 * @param seeds {@code 1..200}
 * @param faults requested faults, each as text
 * @param given requested settings and parameters, each as {@code key=value}
 * @param settings all settings and parameters, by key
 * @param replay the command that runs one seed again
 * @param shrink the command that makes the run of one seed smaller, if it is bad
 */
public record CampaignDescription(
    String app,
    String summary,
    String command,
    String seeds,
    List<String> faults,
    List<String> given,
    Map<String, String> settings,
    LongFunction<String> replay,
    LongFunction<String> shrink) {}
