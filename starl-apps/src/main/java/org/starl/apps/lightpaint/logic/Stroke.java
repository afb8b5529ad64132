package org.starl.apps.lightpaint.logic;

/**
 * A part of the drawing that one robot paints.
 *
 * @param number its index in the list of strokes, the same on every robot
 */
public record Stroke(int number, Polyline path, Ink ink) {}
