package org.starl.apps;

import java.nio.file.Path;
import java.util.Collections;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Files that an app can be run on.
 *
 * @param name of the file or folder, as in {@code four.wpt}
 * @param path of it: a run needs it to be there
 * @param parameters that make a run of it, over the app's defaults
 * @param original how the original StarL fared on it, in a few words; empty if nobody knows
 */
public record Input(String name, Path path, SortedMap<String, String> parameters, String original) {

  public Input {
    parameters = Collections.unmodifiableSortedMap(new TreeMap<>(parameters));
  }
}
