package org.starl.primitives.agreement;

import java.util.List;

/** Makes a proposer's own value, once no vote binds it. */
@FunctionalInterface
public interface Chooser {

  /**
   * @param wishes the wishes of other proposers of the same number, as far as heard, in no particular order
   */
  Value choose(List<Value> wishes);
}
