package org.starl.apps.lightpaint.logic;

/** A line of a drawing, curves flattened. */
public record Line(Polyline path, Ink ink) {}
