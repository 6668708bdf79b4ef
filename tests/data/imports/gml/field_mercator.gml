<?xml version="1.0" encoding="utf-8" ?>
<ogr:FeatureCollection
     gml:id="aFeatureCollection"
     xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
     xsi:schemaLocation="http://ogr.maptools.org/ field_mercator.xsd"
     xmlns:ogr="http://ogr.maptools.org/"
     xmlns:gml="http://www.opengis.net/gml/3.2">
  <gml:boundedBy><gml:Envelope srsName="urn:ogc:def:crs:EPSG::3857"><gml:lowerCorner>1001875.41713946 6800125.45439731</gml:lowerCorner><gml:upperCorner>1002209.37561184 6800487.08812668</gml:upperCorner></gml:Envelope></gml:boundedBy>
                                                                                                                  
  <ogr:featureMember>
    <ogr:field gml:id="field.0">
      <gml:boundedBy><gml:Envelope srsName="urn:ogc:def:crs:EPSG::3857"><gml:lowerCorner>1001875.41713946 6800125.45439731</gml:lowerCorner><gml:upperCorner>1002209.37561184 6800487.08812668</gml:upperCorner></gml:Envelope></gml:boundedBy>
      <ogr:geometryProperty><gml:Polygon srsName="urn:ogc:def:crs:EPSG::3857" gml:id="field.geom.0"><gml:exterior><gml:LinearRing><gml:posList>1001875.41713946 6800125.45439731 1002209.37561184 6800125.45439731 1002209.37561184 6800487.08812668 1001875.41713946 6800487.08812668 1001875.41713946 6800125.45439731</gml:posList></gml:LinearRing></gml:exterior><gml:interior><gml:LinearRing><gml:posList>1001986.73663026 6800215.86131487 1001986.73663026 6800396.67817953 1002098.05612105 6800396.67817953 1002098.05612105 6800215.86131487 1001986.73663026 6800215.86131487</gml:posList></gml:LinearRing></gml:interior></gml:Polygon></ogr:geometryProperty>
      <ogr:id>north</ogr:id>
      <ogr:Name>North Field</ogr:Name>
    </ogr:field>
  </ogr:featureMember>
</ogr:FeatureCollection>
