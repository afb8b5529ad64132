package org.starl.apps;

import java.nio.file.Path;
import java.util.Collections;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Input files of an app.
 *
 * @param name of the file or folder, as in {@code four.wpt}
 * @param path of the file or folder; a run needs it
 * @param parameters of a run with these files, over the app's defaults
 * @param original the original StarL's results on these files, in a few words; empty if unknown
 */
public record Input(String name, Path path, SortedMap<String, String> parameters, String original) {

  public Input {
    parameters = Collections.unmodifiableSortedMap(new TreeMap<>(parameters));
  }
}
