package org.starl.primitives.membership;

import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.ProcessId;

/** Values of this package written briefly, for tests. */
public final class Short {

  private Short() {}

  /** A view as its {@code toString}: {@code 3:a@1,b@3|c@2[A B]}. */
  public static View view(String text) {
    String[] parts = text.split("[:|]", 3);
    SortedMap<ProcessId, Long> admitted = new TreeMap<>();
    SortedMap<ProcessId, View.Ghost> ghosts = new TreeMap<>();
    for (String entry : split(parts[1], ",")) {
      String[] idAndNumber = entry.split("@");
      admitted.put(ProcessId.parse(idAndNumber[0]), Long.valueOf(idAndNumber[1]));
    }
    for (String entry : split(parts.length > 2 ? parts[2] : "", ",")) {
      String[] ghost = entry.split("[@\\[\\]]");
      ghosts.put(
          ProcessId.parse(ghost[0]), new View.Ghost(Long.parseLong(ghost[1]), sections(ghost[2])));
    }
    return new View(Long.parseLong(parts[0]), admitted, ghosts);
  }

  /** Sections with single spaces between them. */
  public static SortedSet<String> sections(String names) {
    return Sections.copyOf(Set.of(split(names, " ")));
  }

  /** A confinement; sections and fencers with single spaces between them. */
  public static Confinement confinement(String who, String sections, String fencers) {
    SortedSet<ProcessId> ids = new TreeSet<>();
    for (String id : split(fencers, " ")) {
      ids.add(ProcessId.parse(id));
    }
    return new Confinement(ProcessId.parse(who), sections(sections), ids);
  }

  private static String[] split(String text, String separator) {
    return text.isEmpty() ? new String[0] : text.split(separator);
  }
}
