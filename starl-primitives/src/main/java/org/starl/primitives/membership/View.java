package org.starl.primitives.membership;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.Participants;
import org.starl.ProcessId;
import org.starl.RobotId;

/**
 * A numbered list of participants. For one instance, equal numbers mean equal lists (agreement), and
 * a list holds everyone admitted before who has not left (inclusion).
 *
 * @param number from 1; 0 is {@link #NONE}, what is known before any view is
 * @param admitted each participant, with the number of the view that admitted it
 */
public record View(long number, SortedMap<ProcessId, Long> admitted) {

  public static final View NONE = new View(0, new TreeMap<>());

  public View {
    if (number < 0) {
      throw new IllegalArgumentException("view number " + number + ": expected 0 or above");
    }
    for (Map.Entry<ProcessId, Long> entry : admitted.entrySet()) {
      if (entry.getValue() > number || entry.getValue() < 1) {
        throw new IllegalArgumentException(
            "view " + number + " lists " + entry.getKey() + " admitted by " + entry.getValue());
      }
    }
    admitted = Collections.unmodifiableSortedMap(new TreeMap<>(admitted));
  }

  /** View 1 of a closed group: {@code ids}, all admitted by it. */
  public static View closed(Collection<ProcessId> ids) {
    SortedMap<ProcessId, Long> admitted = new TreeMap<>();
    for (ProcessId id : ids) {
      admitted.put(id, 1L);
    }
    return new View(1, admitted);
  }

  public boolean contains(ProcessId id) {
    return admitted.containsKey(id);
  }

  /** The number of the view that admitted {@code id}, which this view must list. */
  public long admittedBy(ProcessId id) {
    Long by = admitted.get(id);
    if (by == null) {
      throw new IllegalArgumentException(id + " is not in view " + number);
    }
    return by;
  }

  /** The participants in order. */
  public List<ProcessId> ids() {
    return List.copyOf(admitted.keySet());
  }

  /** The participants' robots. */
  public Participants participants() {
    List<RobotId> robots = new ArrayList<>();
    for (ProcessId id : admitted.keySet()) {
      robots.add(id.robot());
    }
    return Participants.of(robots);
  }

  /** {@code 3:bot0#4294967297@1,bot2#4294967297@3}: number, then who, each {@code @} its view. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder().append(number).append(':');
    String separator = "";
    for (Map.Entry<ProcessId, Long> entry : admitted.entrySet()) {
      text.append(separator).append(entry.getKey()).append('@').append(entry.getValue());
      separator = ",";
    }
    return text.toString();
  }

  /**
   * Reads what {@link #toString} wrote, as a trace has it.
   *
   * @throws IllegalArgumentException if {@code text} is nothing of the kind
   */
  public static View parse(String text) {
    int colon = text.indexOf(':');
    if (colon < 0) {
      throw new IllegalArgumentException("view '" + text + "': expected number:id@number,...");
    }
    SortedMap<ProcessId, Long> admitted = new TreeMap<>();
    String entries = text.substring(colon + 1);
    if (!entries.isEmpty()) {
      for (String entry : entries.split(",", -1)) {
        int at = entry.lastIndexOf('@');
        if (at < 0) {
          throw new IllegalArgumentException("view entry '" + entry + "': expected id@number");
        }
        ProcessId id = ProcessId.parse(entry.substring(0, at));
        admitted.put(id, Long.parseLong(entry.substring(at + 1)));
      }
    }
    return new View(Long.parseLong(text.substring(0, colon)), admitted);
  }
}
