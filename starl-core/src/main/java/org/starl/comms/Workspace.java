package org.starl.comms;

/**
 * What datagrams are written and read with, one at a time. Robots whose strands never run at once
 * may share one, as all robots of a simulation do: what is shared stays in the processor's cache.
 */
public final class Workspace {

  final Header header = new Header();
  final WireReader in = new WireReader();
  final DatagramWriter out = new DatagramWriter();
}
