package org.starl.sim.junit;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.input.BadInput;
import org.starl.input.NearMatches;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;

/** One combination of the values of {@link StarlTest#matrix}. */
public final class Cell {

  static final Cell NONE = new Cell(Map.of());

  private final Map<String, String> values;

  private Cell(Map<String, String> values) {
    this.values = values;
  }

  /**
   * The value of a key.
   *
   * @throws IllegalArgumentException if the matrix has no such key
   */
  public String get(String key) {
    String value = values.get(key);
    if (value == null) {
      throw new IllegalArgumentException(
          "no key '" + key + "' in the matrix" + NearMatches.hint(key, values.keySet()));
    }
    return value;
  }

  boolean isEmpty() {
    return values.isEmpty();
  }

  /**
   * All combinations, the last key's values changing first; an empty one without lines.
   *
   * @throws BadInput if a line is not {@code key=value|value}
   */
  static List<Cell> of(String... lines) {
    List<Map<String, String>> all = List.of(Map.of());
    for (String line : lines) {
      int equals = line.indexOf('=');
      String key = equals < 0 ? "" : line.substring(0, equals).strip();
      if (key.isEmpty() || all.get(0).containsKey(key)) {
        throw new BadInput(
            "matrix: " + BadInput.quote(line) + ": expected key=value|value, each key once");
      }
      List<Map<String, String>> more = new ArrayList<>();
      for (Map<String, String> cell : all) {
        for (String value : line.substring(equals + 1).split("\\|", -1)) {
          Map<String, String> with = new LinkedHashMap<>(cell);
          with.put(key, value.strip());
          more.add(with);
        }
      }
      all = more;
    }
    return all.stream().map(Cell::new).toList();
  }

  /** The settings with the values of the keys that are settings. */
  SimSettings over(SimSettings settings) {
    SimSettings.Builder all = settings.toBuilder();
    for (Setting<?> setting : Setting.all()) {
      String value = values.get(setting.key());
      if (value != null) {
        all.set(setting.key(), value);
      }
    }
    return all.build();
  }

  /** {@code order=set messageLoss=0.3}. */
  @Override
  public String toString() {
    List<String> words = new ArrayList<>();
    values.forEach((key, value) -> words.add(key + "=" + value));
    return String.join(" ", words);
  }
}
