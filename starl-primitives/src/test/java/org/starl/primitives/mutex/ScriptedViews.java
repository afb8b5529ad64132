package org.starl.primitives.mutex;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeMap;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.Membership;
import org.starl.primitives.membership.View;

/** A membership controlled by the test. */
final class ScriptedViews implements Membership {
  private final TreeMap<ProcessId, Long> admitted = new TreeMap<>();
  private final List<Runnable> listeners = new ArrayList<>();
  private ProcessId me;
  private View view = View.NONE;

  ScriptedViews(ProcessId me) {
    this.me = me;
  }

  void admit(ProcessId newMe) {
    admitted.put(newMe, view.number() + 1);
    view = new View(view.number() + 1, admitted);
    me = newMe;
    listeners.forEach(Runnable::run);
  }

  @Override
  public ProcessId me() {
    return me;
  }

  @Override
  public View view() {
    return view;
  }

  @Override
  public boolean mayRequest() {
    return view.contains(me);
  }

  @Override
  public void onChange(Runnable listener) {
    listeners.add(listener);
  }

  @Override
  public void join(Member member) {
    // No participant leaves.
  }

  @Override
  public void refresh() {
    // The test admits all views.
  }

  @Override
  public boolean confines() {
    return false;
  }

  @Override
  public void propose(Confinement confinement) {
    throw new IllegalStateException("not in this test");
  }

  @Override
  public void markIdle(ProcessId id) {
    // It stays in the view.
  }

  @Override
  public void standsIn(SortedSet<String> sections) {
    throw new IllegalStateException("not in this test");
  }
}
