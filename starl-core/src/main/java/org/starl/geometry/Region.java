package org.starl.geometry;

/** A closed set of points of the plane. */
public interface Region {}
