package org.starl.primitives.agreement;

import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.primitives.StarLPrimitive;
import org.starl.trace.Instance;

/** A primitive that decides by a {@link Synod}. */
public abstract class SynodPrimitive implements StarLPrimitive {

  protected final GlobalVarHolder gvh;
  protected final Instance source;
  protected final SynodWire wire;

  /**
   * @param source the instance in the trace
   * @param channel of the Synod's messages
   */
  protected SynodPrimitive(GlobalVarHolder gvh, Instance source, Channel<SynodMessage> channel) {
    this.gvh = gvh;
    this.source = source;
    this.wire = new SynodWire(gvh, source, channel);
  }

  @Override
  public final Instance source() {
    return source;
  }

  @Override
  public final void close() {
    wire.close();
  }
}
