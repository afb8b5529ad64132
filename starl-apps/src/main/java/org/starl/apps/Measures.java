package org.starl.apps;

import java.util.List;

/**
 * One run of an app in numbers that add up over a campaign.
 *
 * @param completed how many robots did what they came for
 * @param waitsNs how long each of them waited for it, in ns
 */
public record Measures(int completed, List<Long> waitsNs) {

  public Measures {
    waitsNs = List.copyOf(waitsNs);
  }
}
