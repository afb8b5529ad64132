package org.starl.primitives.agreement;

import java.util.List;

/** Makes a proposer's own value, once it knows that it is free to choose one. */
@FunctionalInterface
public interface Chooser {

  /**
   * @param wishes what other proposers wish for the same number, as far as heard; each at least
   *     once, in no particular order
   */
  Value choose(List<Value> wishes);
}
