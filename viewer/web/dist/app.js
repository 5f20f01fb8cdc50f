(()=>{var Yp=0,Hh=1,Zp=2;var hr=1,Jp=2,_o=3,$s=0,Kn=1,es=2,fr=0,xo=1,Wh=2,Xh=3,qh=4,Kp=5;var dr=100,jp=101,Qp=102,em=103,tm=104,nm=200,im=201,sm=202,rm=203,$h=204,Yh=205,om=206,am=207,lm=208,cm=209,um=210,hm=211,fm=212,dm=213,pm=214,Xl=0,ql=1,$l=2,so=3,Yl=4,Zl=5,Jl=6,Kl=7,wc=0,mm=1,gm=2,ts=0,Zh=1,Jh=2,Kh=3,jh=4,Qh=5,ef=6,Pa=7;var tf=300,pr=301,vo=302,Tc=303,Ac=304,jl=1e3,Ji=1001,Ql=1002,In=1003,_m=1004;var Ia=1005;var Jn=1006,Ec=1007;var Ss=1008;var zn=1009,nf=1010,sf=1011,yo=1012,Cc=1013,Fi=1014,Si=1015,Oi=1016,Rc=1017,Pc=1018,mr=1020,rf=35902,of=35899,af=1021,lf=1022,ni=1023,_s=1026,Ms=1027,So=1028,Ic=1029,Bi=1030,Lc=1031;var Nc=1033,La=33776,Na=33777,Da=33778,Ua=33779,Dc=35840,Uc=35841,Fc=35842,Oc=35843,Bc=36196,kc=37492,zc=37496,Vc=37488,Gc=37489,Fa=37490,Hc=37491,Wc=37808,Xc=37809,qc=37810,$c=37811,Yc=37812,Zc=37813,Jc=37814,Kc=37815,jc=37816,Qc=37817,eu=37818,tu=37819,nu=37820,iu=37821,su=36492,ru=36494,ou=36495,au=36283,lu=36284,Oa=36285,cu=36286;var oa=2300,ec=2301,Hl=2302,Uh=2303,Fh=2400,Oh=2401,Bh=2402;var xm=3200;var Ba=0,vm=1,bs="",Yn="srgb",aa="srgb-linear",la="linear",Tt="srgb";var Wl=7680;var ym=519,Sm=512,Mm=513,bm=514,cf=515,wm=516,Tm=517,uf=518,hf=519,Am=35044;var ff="300 es",yi=2e3,ro=2001;function py(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function my(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ca(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Em(){let n=ca("canvas");return n.style.display="block",n}var _p={},oo=null;function df(...n){let e="THREE."+n.shift();oo?oo("log",e,...n):console.log(e,...n)}function Cm(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ye(...n){n=Cm(n);let e="THREE."+n.shift();if(oo)oo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function je(...n){n=Cm(n);let e="THREE."+n.shift();if(oo)oo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function ra(...n){let e=n.join(" ");e in _p||(_p[e]=!0,Ye(...n))}function Rm(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var Pm={[Xl]:Xl,[$l]:Jl,[Yl]:Yl,[so]:Zl,[ql]:ql,[Jl]:$l,[Kl]:Kl,[Zl]:so},Ki=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var fh=Math.PI/180,tc=180/Math.PI;function ka(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Bn[n&255]+Bn[n>>8&255]+Bn[n>>16&255]+Bn[n>>24&255]+"-"+Bn[e&255]+Bn[e>>8&255]+"-"+Bn[e>>16&15|64]+Bn[e>>24&255]+"-"+Bn[t&63|128]+Bn[t>>8&255]+"-"+Bn[t>>16&255]+Bn[t>>24&255]+Bn[i&255]+Bn[i>>8&255]+Bn[i>>16&255]+Bn[i>>24&255]).toLowerCase()}function xt(n,e,t){return Math.max(e,Math.min(t,n))}function gy(n,e){return(n%e+e)%e}function dh(n,e,t){return(1-t)*n+t*e}function Im(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function pf(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function _y(n,e){if(e.constructor===Float32Array)return n;let t=pf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function xy(n,e){if(e.constructor===Float32Array)return n;let t=pf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var ut=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(xt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Nn=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],f=r[o+0],p=r[o+1],g=r[o+2],v=r[o+3];if(h!==v||l!==f||c!==p||u!==g){let d=l*f+c*p+u*g+h*v;d<0&&(f=-f,p=-p,g=-g,v=-v,d=-d);let m=1-a;if(d<.9995){let y=Math.acos(d),C=Math.sin(y);m=Math.sin(m*y)/C,a=Math.sin(a*y)/C,l=l*m+f*a,c=c*m+p*a,u=u*m+g*a,h=h*m+v*a}else{l=l*m+f*a,c=c*m+p*a,u=u*m+g*a,h=h*m+v*a;let y=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=y,c*=y,u*=y,h*=y}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],p=r[o+2],g=r[o+3];return e[t]=a*g+u*h+l*p-c*f,e[t+1]=l*g+u*f+c*h-a*p,e[t+2]=c*g+u*p+a*f-l*h,e[t+3]=u*g-a*h-l*f-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),p=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*p*g,this._y=c*p*h-f*u*g,this._z=c*u*g+f*p*h,this._w=c*u*h-f*p*g;break;case"YXZ":this._x=f*u*h+c*p*g,this._y=c*p*h-f*u*g,this._z=c*u*g-f*p*h,this._w=c*u*h+f*p*g;break;case"ZXY":this._x=f*u*h-c*p*g,this._y=c*p*h+f*u*g,this._z=c*u*g+f*p*h,this._w=c*u*h-f*p*g;break;case"ZYX":this._x=f*u*h-c*p*g,this._y=c*p*h+f*u*g,this._z=c*u*g-f*p*h,this._w=c*u*h+f*p*g;break;case"YZX":this._x=f*u*h+c*p*g,this._y=c*p*h+f*u*g,this._z=c*u*g-f*p*h,this._w=c*u*h-f*p*g;break;case"XZY":this._x=f*u*h-c*p*g,this._y=c*p*h-f*u*g,this._z=c*u*g+f*p*h,this._w=c*u*h+f*p*g;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=i+a+h;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(i>a&&i>h){let p=2*Math.sqrt(1+i-a-h);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>h){let p=2*Math.sqrt(1+a-i-h);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+h-i-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(xt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},W=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(xp.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(xp.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return ph.copy(this).projectOnVector(e),this.sub(ph)}reflect(e){return this.sub(ph.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(xt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},ph=new W,xp=new Nn,et=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],p=i[5],g=i[8],v=s[0],d=s[3],m=s[6],y=s[1],C=s[4],b=s[7],P=s[2],A=s[5],x=s[8];return r[0]=o*v+a*y+l*P,r[3]=o*d+a*C+l*A,r[6]=o*m+a*b+l*x,r[1]=c*v+u*y+h*P,r[4]=c*d+u*C+h*A,r[7]=c*m+u*b+h*x,r[2]=f*v+p*y+g*P,r[5]=f*d+p*C+g*A,r[8]=f*m+p*b+g*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,p=c*r-o*l,g=t*h+i*f+s*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/g;return e[0]=h*v,e[1]=(s*c-u*i)*v,e[2]=(a*i-s*o)*v,e[3]=f*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=p*v,e[7]=(i*l-c*t)*v,e[8]=(o*t-i*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return ra("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(mh.makeScale(e,t)),this}rotate(e){return ra("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(mh.makeRotation(-e)),this}translate(e,t){return ra("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(mh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},mh=new et,vp=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),yp=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function vy(){let n={enabled:!0,workingColorSpace:aa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Tt&&(s.r=gs(s.r),s.g=gs(s.g),s.b=gs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Tt&&(s.r=io(s.r),s.g=io(s.g),s.b=io(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===bs?la:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[aa]:{primaries:e,whitePoint:i,transfer:la,toXYZ:vp,fromXYZ:yp,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Yn},outputColorSpaceConfig:{drawingBufferColorSpace:Yn}},[Yn]:{primaries:e,whitePoint:i,transfer:Tt,toXYZ:vp,fromXYZ:yp,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Yn}}}),n}var gt=vy();function gs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function io(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Hr,nc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Hr===void 0&&(Hr=ca("canvas")),Hr.width=e.width,Hr.height=e.height;let s=Hr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Hr}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=ca("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=gs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(gs(t[i]/255)*255):t[i]=gs(t[i]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},yy=0,ao=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:yy++}),this.uuid=ka(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(gh(s[o].image)):r.push(gh(s[o]))}else r=gh(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function gh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?nc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var Sy=0,_h=new W,ei=class n extends Ki{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Ji,s=Ji,r=Jn,o=Ss,a=ni,l=zn,c=n.DEFAULT_ANISOTROPY,u=bs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Sy++}),this.uuid=ka(),this.name="",this.source=new ao(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ut(0,0),this.repeat=new ut(1,1),this.center=new ut(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(_h).x}get height(){return this.source.getSize(_h).y}get depth(){return this.source.getSize(_h).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ye(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==tf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case jl:e.x=e.x-Math.floor(e.x);break;case Ji:e.x=e.x<0?0:1;break;case Ql:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case jl:e.y=e.y-Math.floor(e.y);break;case Ji:e.y=e.y<0?0:1;break;case Ql:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ei.DEFAULT_IMAGE=null;ei.DEFAULT_MAPPING=tf;ei.DEFAULT_ANISOTROPY=1;var Bt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],p=l[5],g=l[9],v=l[2],d=l[6],m=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(g-d)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(g+d)<.1&&Math.abs(c+p+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let C=(c+1)/2,b=(p+1)/2,P=(m+1)/2,A=(u+f)/4,x=(h+v)/4,T=(g+d)/4;return C>b&&C>P?C<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(C),s=A/i,r=x/i):b>P?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=A/s,r=T/s):P<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),i=x/r,s=T/r),this.set(i,s,r,t),this}let y=Math.sqrt((d-g)*(d-g)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(y)<.001&&(y=1),this.x=(d-g)/y,this.y=(h-v)/y,this.z=(f-u)/y,this.w=Math.acos((c+p+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this.w=xt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this.w=xt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ic=class extends Ki{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Bt(0,0,e,t),this.scissorTest=!1,this.viewport=new Bt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ei({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Jn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new ao(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ui=class extends ic{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},ua=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var sc=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var yt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,f,p,g,v,d){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,f,p,g,v,d)}set(e,t,i,s,r,o,a,l,c,u,h,f,p,g,v,d){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=f,m[3]=p,m[7]=g,m[11]=v,m[15]=d,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Wr.setFromMatrixColumn(e,0).length(),r=1/Wr.setFromMatrixColumn(e,1).length(),o=1/Wr.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,p=o*h,g=a*u,v=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=p+g*c,t[5]=f-v*c,t[9]=-a*l,t[2]=v-f*c,t[6]=g+p*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,p=l*h,g=c*u,v=c*h;t[0]=f+v*a,t[4]=g*a-p,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=p*a-g,t[6]=v+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,p=l*h,g=c*u,v=c*h;t[0]=f-v*a,t[4]=-o*h,t[8]=g+p*a,t[1]=p+g*a,t[5]=o*u,t[9]=v-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,p=o*h,g=a*u,v=a*h;t[0]=l*u,t[4]=g*c-p,t[8]=f*c+v,t[1]=l*h,t[5]=v*c+f,t[9]=p*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,p=o*c,g=a*l,v=a*c;t[0]=l*u,t[4]=v-f*h,t[8]=g*h+p,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=p*h+g,t[10]=f-v*h}else if(e.order==="XZY"){let f=o*l,p=o*c,g=a*l,v=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+v,t[5]=o*u,t[9]=p*h-g,t[2]=g*h-p,t[6]=a*u,t[10]=v*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(My,e,by)}lookAt(e,t,i){let s=this.elements;return li.subVectors(e,t),li.lengthSq()===0&&(li.z=1),li.normalize(),Us.crossVectors(i,li),Us.lengthSq()===0&&(Math.abs(i.z)===1?li.x+=1e-4:li.z+=1e-4,li.normalize(),Us.crossVectors(i,li)),Us.normalize(),yl.crossVectors(li,Us),s[0]=Us.x,s[4]=yl.x,s[8]=li.x,s[1]=Us.y,s[5]=yl.y,s[9]=li.y,s[2]=Us.z,s[6]=yl.z,s[10]=li.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],p=i[13],g=i[2],v=i[6],d=i[10],m=i[14],y=i[3],C=i[7],b=i[11],P=i[15],A=s[0],x=s[4],T=s[8],B=s[12],D=s[1],I=s[5],k=s[9],V=s[13],N=s[2],H=s[6],$=s[10],G=s[14],le=s[3],J=s[7],j=s[11],ie=s[15];return r[0]=o*A+a*D+l*N+c*le,r[4]=o*x+a*I+l*H+c*J,r[8]=o*T+a*k+l*$+c*j,r[12]=o*B+a*V+l*G+c*ie,r[1]=u*A+h*D+f*N+p*le,r[5]=u*x+h*I+f*H+p*J,r[9]=u*T+h*k+f*$+p*j,r[13]=u*B+h*V+f*G+p*ie,r[2]=g*A+v*D+d*N+m*le,r[6]=g*x+v*I+d*H+m*J,r[10]=g*T+v*k+d*$+m*j,r[14]=g*B+v*V+d*G+m*ie,r[3]=y*A+C*D+b*N+P*le,r[7]=y*x+C*I+b*H+P*J,r[11]=y*T+C*k+b*$+P*j,r[15]=y*B+C*V+b*G+P*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],p=e[14],g=e[3],v=e[7],d=e[11],m=e[15],y=l*p-c*f,C=a*p-c*h,b=a*f-l*h,P=o*p-c*u,A=o*f-l*u,x=o*h-a*u;return t*(v*y-d*C+m*b)-i*(g*y-d*P+m*A)+s*(g*C-v*P+m*x)-r*(g*b-v*A+d*x)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],p=e[11],g=e[12],v=e[13],d=e[14],m=e[15],y=t*a-i*o,C=t*l-s*o,b=t*c-r*o,P=i*l-s*a,A=i*c-r*a,x=s*c-r*l,T=u*v-h*g,B=u*d-f*g,D=u*m-p*g,I=h*d-f*v,k=h*m-p*v,V=f*m-p*d,N=y*V-C*k+b*I+P*D-A*B+x*T;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/N;return e[0]=(a*V-l*k+c*I)*H,e[1]=(s*k-i*V-r*I)*H,e[2]=(v*x-d*A+m*P)*H,e[3]=(f*A-h*x-p*P)*H,e[4]=(l*D-o*V-c*B)*H,e[5]=(t*V-s*D+r*B)*H,e[6]=(d*b-g*x-m*C)*H,e[7]=(u*x-f*b+p*C)*H,e[8]=(o*k-a*D+c*T)*H,e[9]=(i*D-t*k-r*T)*H,e[10]=(g*A-v*b+m*y)*H,e[11]=(h*b-u*A-p*y)*H,e[12]=(a*B-o*I-l*T)*H,e[13]=(t*I-i*B+s*T)*H,e[14]=(v*C-g*P-d*y)*H,e[15]=(u*P-h*C+f*y)*H,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,p=r*u,g=r*h,v=o*u,d=o*h,m=a*h,y=l*c,C=l*u,b=l*h,P=i.x,A=i.y,x=i.z;return s[0]=(1-(v+m))*P,s[1]=(p+b)*P,s[2]=(g-C)*P,s[3]=0,s[4]=(p-b)*A,s[5]=(1-(f+m))*A,s[6]=(d+y)*A,s[7]=0,s[8]=(g+C)*x,s[9]=(d-y)*x,s[10]=(1-(f+v))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Wr.set(s[0],s[1],s[2]).length(),a=Wr.set(s[4],s[5],s[6]).length(),l=Wr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Pi.copy(this);let c=1/o,u=1/a,h=1/l;return Pi.elements[0]*=c,Pi.elements[1]*=c,Pi.elements[2]*=c,Pi.elements[4]*=u,Pi.elements[5]*=u,Pi.elements[6]*=u,Pi.elements[8]*=h,Pi.elements[9]*=h,Pi.elements[10]*=h,t.setFromRotationMatrix(Pi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=yi,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),f=(t+e)/(t-e),p=(i+s)/(i-s),g,v;if(l)g=r/(o-r),v=o*r/(o-r);else if(a===yi)g=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===ro)g=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=yi,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),f=-(t+e)/(t-e),p=-(i+s)/(i-s),g,v;if(l)g=1/(o-r),v=o/(o-r);else if(a===yi)g=-2/(o-r),v=-(o+r)/(o-r);else if(a===ro)g=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Wr=new W,Pi=new yt,My=new W(0,0,0),by=new W(1,1,1),Us=new W,yl=new W,li=new W,Sp=new yt,Mp=new Nn,ji=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(xt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(xt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-xt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Sp.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Sp,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Mp.setFromEuler(this),this.setFromQuaternion(Mp,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ji.DEFAULT_ORDER="XYZ";var lo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},wy=0,bp=new W,Xr=new Nn,hs=new yt,Sl=new W,jo=new W,Ty=new W,Ay=new Nn,wp=new W(1,0,0),Tp=new W(0,1,0),Ap=new W(0,0,1),Ep={type:"added"},Ey={type:"removed"},qr={type:"childadded",child:null},xh={type:"childremoved",child:null},Dn=class n extends Ki{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:wy++}),this.uuid=ka(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new W,t=new ji,i=new Nn,s=new W(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new yt},normalMatrix:{value:new et}}),this.matrix=new yt,this.matrixWorld=new yt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new lo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Xr.setFromAxisAngle(e,t),this.quaternion.multiply(Xr),this}rotateOnWorldAxis(e,t){return Xr.setFromAxisAngle(e,t),this.quaternion.premultiply(Xr),this}rotateX(e){return this.rotateOnAxis(wp,e)}rotateY(e){return this.rotateOnAxis(Tp,e)}rotateZ(e){return this.rotateOnAxis(Ap,e)}translateOnAxis(e,t){return bp.copy(e).applyQuaternion(this.quaternion),this.position.add(bp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(wp,e)}translateY(e){return this.translateOnAxis(Tp,e)}translateZ(e){return this.translateOnAxis(Ap,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(hs.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Sl.copy(e):Sl.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),jo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?hs.lookAt(jo,Sl,this.up):hs.lookAt(Sl,jo,this.up),this.quaternion.setFromRotationMatrix(hs),s&&(hs.extractRotation(s.matrixWorld),Xr.setFromRotationMatrix(hs),this.quaternion.premultiply(Xr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(je("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Ep),qr.child=e,this.dispatchEvent(qr),qr.child=null):je("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Ey),xh.child=e,this.dispatchEvent(xh),xh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),hs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),hs.multiply(e.parent.matrixWorld)),e.applyMatrix4(hs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Ep),qr.child=e,this.dispatchEvent(qr),qr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(jo,e,Ty),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(jo,Ay,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),p=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),p.length>0&&(i.animations=p),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Dn.DEFAULT_UP=new W(0,1,0);Dn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Dn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var gn=class extends Dn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Cy={type:"move"},co=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new gn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new gn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new W,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new W),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new gn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new W,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new W,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let d=t.getJointPose(v,i),m=this._getHandJoint(c,v);d!==null&&(m.matrix.fromArray(d.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=d.radius),m.visible=d!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),p=.02,g=.005;c.inputState.pinching&&f>p+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=p-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Cy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new gn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Lm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Fs={h:0,s:0,l:0},Ml={h:0,s:0,l:0};function vh(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var Xe=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Yn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,gt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=gt.workingColorSpace){return this.r=e,this.g=t,this.b=i,gt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=gt.workingColorSpace){if(e=gy(e,1),t=xt(t,0,1),i=xt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=vh(o,r,e+1/3),this.g=vh(o,r,e),this.b=vh(o,r,e-1/3)}return gt.colorSpaceToWorking(this,s),this}setStyle(e,t=Yn){function i(r){r!==void 0&&parseFloat(r)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Yn){let i=Lm[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=gs(e.r),this.g=gs(e.g),this.b=gs(e.b),this}copyLinearToSRGB(e){return this.r=io(e.r),this.g=io(e.g),this.b=io(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Yn){return gt.workingToColorSpace(kn.copy(this),e),Math.round(xt(kn.r*255,0,255))*65536+Math.round(xt(kn.g*255,0,255))*256+Math.round(xt(kn.b*255,0,255))}getHexString(e=Yn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=gt.workingColorSpace){gt.workingToColorSpace(kn.copy(this),t);let i=kn.r,s=kn.g,r=kn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=gt.workingColorSpace){return gt.workingToColorSpace(kn.copy(this),t),e.r=kn.r,e.g=kn.g,e.b=kn.b,e}getStyle(e=Yn){gt.workingToColorSpace(kn.copy(this),e);let t=kn.r,i=kn.g,s=kn.b;return e!==Yn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Fs),this.setHSL(Fs.h+e,Fs.s+t,Fs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Fs),e.getHSL(Ml);let i=dh(Fs.h,Ml.h,t),s=dh(Fs.s,Ml.s,t),r=dh(Fs.l,Ml.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},kn=new Xe;Xe.NAMES=Lm;var ha=class extends Dn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ji,this.environmentIntensity=1,this.environmentRotation=new ji,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ii=new W,fs=new W,yh=new W,ds=new W,$r=new W,Yr=new W,Cp=new W,Sh=new W,Mh=new W,bh=new W,wh=new Bt,Th=new Bt,Ah=new Bt,zs=class n{constructor(e=new W,t=new W,i=new W){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Ii.subVectors(e,t),s.cross(Ii);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Ii.subVectors(s,t),fs.subVectors(i,t),yh.subVectors(e,t);let o=Ii.dot(Ii),a=Ii.dot(fs),l=Ii.dot(yh),c=fs.dot(fs),u=fs.dot(yh),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,p=(c*l-a*u)*f,g=(o*u-a*l)*f;return r.set(1-p-g,g,p)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,ds)===null?!1:ds.x>=0&&ds.y>=0&&ds.x+ds.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,ds)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ds.x),l.addScaledVector(o,ds.y),l.addScaledVector(a,ds.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return wh.setScalar(0),Th.setScalar(0),Ah.setScalar(0),wh.fromBufferAttribute(e,t),Th.fromBufferAttribute(e,i),Ah.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(wh,r.x),o.addScaledVector(Th,r.y),o.addScaledVector(Ah,r.z),o}static isFrontFacing(e,t,i,s){return Ii.subVectors(i,t),fs.subVectors(e,t),Ii.cross(fs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ii.subVectors(this.c,this.b),fs.subVectors(this.a,this.b),Ii.cross(fs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;$r.subVectors(s,i),Yr.subVectors(r,i),Sh.subVectors(e,i);let l=$r.dot(Sh),c=Yr.dot(Sh);if(l<=0&&c<=0)return t.copy(i);Mh.subVectors(e,s);let u=$r.dot(Mh),h=Yr.dot(Mh);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector($r,o);bh.subVectors(e,r);let p=$r.dot(bh),g=Yr.dot(bh);if(g>=0&&p<=g)return t.copy(r);let v=p*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(i).addScaledVector(Yr,a);let d=u*g-p*h;if(d<=0&&h-u>=0&&p-g>=0)return Cp.subVectors(r,s),a=(h-u)/(h-u+(p-g)),t.copy(s).addScaledVector(Cp,a);let m=1/(d+v+f);return o=v*m,a=f*m,t.copy(i).addScaledVector($r,o).addScaledVector(Yr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Qi=class{constructor(e=new W(1/0,1/0,1/0),t=new W(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Li.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Li.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Li.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Li):Li.fromBufferAttribute(r,o),Li.applyMatrix4(e.matrixWorld),this.expandByPoint(Li);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),bl.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),bl.copy(i.boundingBox)),bl.applyMatrix4(e.matrixWorld),this.union(bl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Li),Li.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Qo),wl.subVectors(this.max,Qo),Zr.subVectors(e.a,Qo),Jr.subVectors(e.b,Qo),Kr.subVectors(e.c,Qo),Os.subVectors(Jr,Zr),Bs.subVectors(Kr,Jr),rr.subVectors(Zr,Kr);let t=[0,-Os.z,Os.y,0,-Bs.z,Bs.y,0,-rr.z,rr.y,Os.z,0,-Os.x,Bs.z,0,-Bs.x,rr.z,0,-rr.x,-Os.y,Os.x,0,-Bs.y,Bs.x,0,-rr.y,rr.x,0];return!Eh(t,Zr,Jr,Kr,wl)||(t=[1,0,0,0,1,0,0,0,1],!Eh(t,Zr,Jr,Kr,wl))?!1:(Tl.crossVectors(Os,Bs),t=[Tl.x,Tl.y,Tl.z],Eh(t,Zr,Jr,Kr,wl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Li).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Li).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ps[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ps[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ps[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ps[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ps[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ps[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ps[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ps[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ps),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ps=[new W,new W,new W,new W,new W,new W,new W,new W],Li=new W,bl=new Qi,Zr=new W,Jr=new W,Kr=new W,Os=new W,Bs=new W,rr=new W,Qo=new W,wl=new W,Tl=new W,or=new W;function Eh(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){or.fromArray(n,r);let a=s.x*Math.abs(or.x)+s.y*Math.abs(or.y)+s.z*Math.abs(or.z),l=e.dot(or),c=t.dot(or),u=i.dot(or);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var mn=new W,Al=new ut,Ry=0,ln=class extends Ki{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ry++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Am,this.updateRanges=[],this.gpuType=Si,this.version=0,this._normalizationScale=e!==void 0?pf(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Al.fromBufferAttribute(this,t),Al.applyMatrix3(e),this.setXY(t,Al.x,Al.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)mn.fromBufferAttribute(this,t),mn.applyMatrix3(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)mn.fromBufferAttribute(this,t),mn.applyMatrix4(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)mn.fromBufferAttribute(this,t),mn.applyNormalMatrix(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)mn.fromBufferAttribute(this,t),mn.transformDirection(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):_y(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):xy(e,this.array)}};var fa=class extends ln{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var da=class extends ln{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Kt=class extends ln{constructor(e,t,i){super(new Float32Array(e),t,i)}},Py=new Qi,ea=new W,Ch=new W,xs=class{constructor(e=new W,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):Py.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ea.subVectors(e,this.center);let t=ea.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(ea,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ch.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ea.copy(e.center).add(Ch)),this.expandByPoint(ea.copy(e.center).sub(Ch))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Iy=0,vi=new yt,Rh=new Dn,jr=new W,ci=new Qi,ta=new Qi,Pn=new W,Un=class n extends Ki{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Iy++}),this.uuid=ka(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(py(e)?da:fa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new et().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return vi.makeRotationFromQuaternion(e),this.applyMatrix4(vi),this}rotateX(e){return vi.makeRotationX(e),this.applyMatrix4(vi),this}rotateY(e){return vi.makeRotationY(e),this.applyMatrix4(vi),this}rotateZ(e){return vi.makeRotationZ(e),this.applyMatrix4(vi),this}translate(e,t,i){return vi.makeTranslation(e,t,i),this.applyMatrix4(vi),this}scale(e,t,i){return vi.makeScale(e,t,i),this.applyMatrix4(vi),this}lookAt(e){return Rh.lookAt(e),Rh.updateMatrix(),this.applyMatrix4(Rh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(jr).negate(),this.translate(jr.x,jr.y,jr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Kt(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Qi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){je("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new W(-1/0,-1/0,-1/0),new W(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];ci.setFromBufferAttribute(r),this.morphTargetsRelative?(Pn.addVectors(this.boundingBox.min,ci.min),this.boundingBox.expandByPoint(Pn),Pn.addVectors(this.boundingBox.max,ci.max),this.boundingBox.expandByPoint(Pn)):(this.boundingBox.expandByPoint(ci.min),this.boundingBox.expandByPoint(ci.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&je('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new xs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){je("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new W,1/0);return}if(e){let i=this.boundingSphere.center;if(ci.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ta.setFromBufferAttribute(a),this.morphTargetsRelative?(Pn.addVectors(ci.min,ta.min),ci.expandByPoint(Pn),Pn.addVectors(ci.max,ta.max),ci.expandByPoint(Pn)):(ci.expandByPoint(ta.min),ci.expandByPoint(ta.max))}ci.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Pn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Pn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Pn.fromBufferAttribute(a,c),l&&(jr.fromBufferAttribute(e,c),Pn.add(jr)),s=Math.max(s,i.distanceToSquared(Pn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&je('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){je("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new ln(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let B=0;B<i.count;B++)a[B]=new W,l[B]=new W;let u=new W,h=new W,f=new W,p=new ut,g=new ut,v=new ut,d=new W,m=new W;function y(B,D,I){c[B]=c[D]=c[I]=1,u.fromBufferAttribute(i,B),h.fromBufferAttribute(i,D),f.fromBufferAttribute(i,I),p.fromBufferAttribute(r,B),g.fromBufferAttribute(r,D),v.fromBufferAttribute(r,I),h.sub(u),f.sub(u),g.sub(p),v.sub(p);let k=1/(g.x*v.y-v.x*g.y);isFinite(k)&&(d.copy(h).multiplyScalar(v.y).addScaledVector(f,-g.y).multiplyScalar(k),m.copy(f).multiplyScalar(g.x).addScaledVector(h,-v.x).multiplyScalar(k),a[B].add(d),a[D].add(d),a[I].add(d),l[B].add(m),l[D].add(m),l[I].add(m))}let C=this.groups;C.length===0&&(C=[{start:0,count:e.count}]);for(let B=0,D=C.length;B<D;++B){let I=C[B],k=I.start,V=I.count;for(let N=k,H=k+V;N<H;N+=3)y(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let b=new W,P=new W,A=new W,x=new W;function T(B){A.fromBufferAttribute(s,B),x.copy(A);let D=a[B];b.copy(D),b.sub(A.multiplyScalar(A.dot(D))).normalize(),P.crossVectors(x,D);let k=P.dot(l[B])<0?-1:1;o.setXYZW(B,b.x,b.y,b.z,k)}for(let B=0,D=i.count;B<D;++B)c[B]&&T(B);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new ln(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,p=i.count;f<p;f++)i.setXYZ(f,0,0,0);let s=new W,r=new W,o=new W,a=new W,l=new W,c=new W,u=new W,h=new W;if(e)for(let f=0,p=e.count;f<p;f+=3){let g=e.getX(f+0),v=e.getX(f+1),d=e.getX(f+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,d),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,d),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(d,c.x,c.y,c.z)}else for(let f=0,p=t.count;f<p;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Pn.fromBufferAttribute(e,t),Pn.normalize(),e.setXYZ(t,Pn.x,Pn.y,Pn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),p=0,g=0;for(let v=0,d=l.length;v<d;v++){a.isInterleavedBufferAttribute?p=l[v]*a.data.stride+a.offset:p=l[v]*u;for(let m=0;m<u;m++)f[g++]=c[p++]}return new ln(f,u,h)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],p=e(f,i);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let p=c[h];u.push(p.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,p=h.length;f<p;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Ph=new W,Ly=new W,Ny=new et,Ni=class{constructor(e=new W(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Ph.subVectors(i,t).cross(Ly.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Ph),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||Ny.getNormalMatrix(e),s=this.coplanarPoint(Ph).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Dy=0,Di=class extends Ki{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Dy++}),this.uuid=ka(),this.name="",this.type="Material",this.blending=xo,this.side=$s,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=$h,this.blendDst=Yh,this.blendEquation=dr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Xe(0,0,0),this.blendAlpha=0,this.depthFunc=so,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=ym,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Wl,this.stencilZFail=Wl,this.stencilZPass=Wl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Xe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Ni().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new ut().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ut().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ms=new W,Ih=new W,El=new W,Cl=new W,uo=class{constructor(e=new W,t=new W(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ms)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ms.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ms.copy(this.origin).addScaledVector(this.direction,t),ms.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Ih.copy(e).add(t).multiplyScalar(.5),El.copy(t).sub(e).normalize(),Cl.copy(this.origin).sub(Ih);let r=e.distanceTo(t)*.5,o=-this.direction.dot(El),a=Cl.dot(this.direction),l=-Cl.dot(El),c=Cl.lengthSq(),u=Math.abs(1-o*o),h,f,p,g;if(u>0)if(h=o*l-a,f=o*a-l,g=r*u,h>=0)if(f>=-g)if(f<=g){let v=1/u;h*=v,f*=v,p=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c):f<=g?(h=0,f=Math.min(Math.max(-r,-l),r),p=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Ih).addScaledVector(El,f),p}intersectSphere(e,t){if(e.radius<0)return null;ms.subVectors(e.center,this.origin);let i=ms.dot(this.direction),s=ms.dot(ms)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,ms)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,f=e.y-o.y,p=e.z-o.z,g=t.x-o.x,v=t.y-o.y,d=t.z-o.z,m=i.x-o.x,y=i.y-o.y,C=i.z-o.z,b=Math.abs(l),P=Math.abs(c),A=Math.abs(u),x,T,B,D,I,k,V,N,H,$,G,le;if(b>=P&&b>=A?(B=l,k=h,H=g,le=m,l>=0?(x=c,T=u,D=f,I=p,V=v,N=d,$=y,G=C):(x=u,T=c,D=p,I=f,V=d,N=v,$=C,G=y)):P>=A?(B=c,k=f,H=v,le=y,c>=0?(x=u,T=l,D=p,I=h,V=d,N=g,$=C,G=m):(x=l,T=u,D=h,I=p,V=g,N=d,$=m,G=C)):(B=u,k=p,H=d,le=C,u>=0?(x=l,T=c,D=h,I=f,V=g,N=v,$=m,G=y):(x=c,T=l,D=f,I=h,V=v,N=g,$=y,G=m)),B===0)return null;let J=x/B,j=T/B,ie=1/B,fe=D-J*k,ue=I-j*k,Q=V-J*H,me=N-j*H,xe=$-J*le,Ee=G-j*le,Me=xe*me-Ee*Q,He=fe*Ee-ue*xe,it=Q*ue-me*fe;if(s){if(Me<0||He<0||it<0)return null}else if((Me<0||He<0||it<0)&&(Me>0||He>0||it>0))return null;let Ve=Me+He+it;if(Ve===0)return null;let ct=ie*(Me*k+He*H+it*le);return(Ve>0?ct<0:ct>0)?null:this.at(ct/Ve,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Vs=class extends Di{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Xe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ji,this.combine=wc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Rp=new yt,ar=new uo,Rl=new xs,Pp=new W,Pl=new W,Il=new W,Ll=new W,Lh=new W,Nl=new W,Ip=new W,Dl=new W,kt=class extends Dn{constructor(e=new Un,t=new Vs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Nl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Lh.fromBufferAttribute(h,e),o?Nl.addScaledVector(Lh,u):Nl.addScaledVector(Lh.sub(t),u))}t.add(Nl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Rl.copy(i.boundingSphere),Rl.applyMatrix4(r),ar.copy(e.ray).recast(e.near),!(Rl.containsPoint(ar.origin)===!1&&(ar.intersectSphere(Rl,Pp)===null||ar.origin.distanceToSquared(Pp)>(e.far-e.near)**2))&&(Rp.copy(r).invert(),ar.copy(e.ray).applyMatrix4(Rp),!(i.boundingBox!==null&&ar.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,ar)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){let d=f[g],m=o[d.materialIndex],y=Math.max(d.start,p.start),C=Math.min(a.count,Math.min(d.start+d.count,p.start+p.count));for(let b=y,P=C;b<P;b+=3){let A=a.getX(b),x=a.getX(b+1),T=a.getX(b+2);s=Ul(this,m,e,i,c,u,h,A,x,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=d.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),v=Math.min(a.count,p.start+p.count);for(let d=g,m=v;d<m;d+=3){let y=a.getX(d),C=a.getX(d+1),b=a.getX(d+2);s=Ul(this,o,e,i,c,u,h,y,C,b),s&&(s.faceIndex=Math.floor(d/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){let d=f[g],m=o[d.materialIndex],y=Math.max(d.start,p.start),C=Math.min(l.count,Math.min(d.start+d.count,p.start+p.count));for(let b=y,P=C;b<P;b+=3){let A=b,x=b+1,T=b+2;s=Ul(this,m,e,i,c,u,h,A,x,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=d.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),v=Math.min(l.count,p.start+p.count);for(let d=g,m=v;d<m;d+=3){let y=d,C=d+1,b=d+2;s=Ul(this,o,e,i,c,u,h,y,C,b),s&&(s.faceIndex=Math.floor(d/3),t.push(s))}}}};function Uy(n,e,t,i,s,r,o,a){let l;if(e.side===Kn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===$s,a),l===null)return null;Dl.copy(a),Dl.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Dl);return c<t.near||c>t.far?null:{distance:c,point:Dl.clone(),object:n}}function Ul(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Pl),n.getVertexPosition(l,Il),n.getVertexPosition(c,Ll);let u=Uy(n,e,t,i,Pl,Il,Ll,Ip);if(u){let h=new W;zs.getBarycoord(Ip,Pl,Il,Ll,h),s&&(u.uv=zs.getInterpolatedAttribute(s,a,l,c,h,new ut)),r&&(u.uv1=zs.getInterpolatedAttribute(r,a,l,c,h,new ut)),o&&(u.normal=zs.getInterpolatedAttribute(o,a,l,c,h,new W),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new W,materialIndex:0};zs.getNormal(Pl,Il,Ll,f.normal),u.face=f,u.barycoord=h}return u}var cr=class extends ei{constructor(e=null,t=1,i=1,s,r,o,a,l,c=In,u=In,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var pa=class extends ln{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Qr=new yt,Lp=new yt,Fl=[],Np=new Qi,Fy=new yt,na=new kt,ia=new xs,ma=class extends kt{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new pa(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,Fy)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Qi),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Qr),Np.copy(e.boundingBox).applyMatrix4(Qr),this.boundingBox.union(Np)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new xs),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Qr),ia.copy(e.boundingSphere).applyMatrix4(Qr),this.boundingSphere.union(ia)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(na.geometry=this.geometry,na.material=this.material,na.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ia.copy(this.boundingSphere),ia.applyMatrix4(i),e.ray.intersectsSphere(ia)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Qr),Lp.multiplyMatrices(i,Qr),na.matrixWorld=Lp,na.raycast(e,Fl);for(let o=0,a=Fl.length;o<a;o++){let l=Fl[o];l.instanceId=r,l.object=this,t.push(l)}Fl.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new pa(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new cr(new Float32Array(s*this.count),s,this.count,So,Si));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},lr=new xs,Oy=new ut(.5,.5),Ol=new W,Gs=class{constructor(e=new Ni,t=new Ni,i=new Ni,s=new Ni,r=new Ni,o=new Ni){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=yi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],p=r[7],g=r[8],v=r[9],d=r[10],m=r[11],y=r[12],C=r[13],b=r[14],P=r[15];if(s[0].setComponents(c-o,p-u,m-g,P-y).normalize(),s[1].setComponents(c+o,p+u,m+g,P+y).normalize(),s[2].setComponents(c+a,p+h,m+v,P+C).normalize(),s[3].setComponents(c-a,p-h,m-v,P-C).normalize(),i)s[4].setComponents(l,f,d,b).normalize(),s[5].setComponents(c-l,p-f,m-d,P-b).normalize();else if(s[4].setComponents(c-l,p-f,m-d,P-b).normalize(),t===yi)s[5].setComponents(c+l,p+f,m+d,P+b).normalize();else if(t===ro)s[5].setComponents(l,f,d,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),lr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),lr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(lr)}intersectsSprite(e){lr.center.set(0,0,0);let t=Oy.distanceTo(e.center);return lr.radius=.7071067811865476+t,lr.applyMatrix4(e.matrixWorld),this.intersectsSphere(lr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Ol.x=s.normal.x>0?e.max.x:e.min.x,Ol.y=s.normal.y>0?e.max.y:e.min.y,Ol.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Ol)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Dp=new yt,rc=class n{constructor(){this.coordinateSystem=yi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Dp.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Gs),i[s].setFromProjectionMatrix(Dp,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Gs),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var ho=class extends Di{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Xe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},oc=new W,ac=new W,Up=new yt,sa=new uo,Bl=new xs,Nh=new W,Fp=new W,lc=class extends Dn{constructor(e=new Un,t=new ho){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)oc.fromBufferAttribute(t,s-1),ac.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=oc.distanceTo(ac);e.setAttribute("lineDistance",new Kt(i,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Bl.copy(i.boundingSphere),Bl.applyMatrix4(s),Bl.radius+=r,e.ray.intersectsSphere(Bl)===!1)return;Up.copy(s).invert(),sa.copy(e.ray).applyMatrix4(Up);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let p=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let v=p,d=g-1;v<d;v+=c){let m=u.getX(v),y=u.getX(v+1),C=kl(this,e,sa,l,m,y,v);C&&t.push(C)}if(this.isLineLoop){let v=u.getX(g-1),d=u.getX(p),m=kl(this,e,sa,l,v,d,g-1);m&&t.push(m)}}else{let p=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let v=p,d=g-1;v<d;v+=c){let m=kl(this,e,sa,l,v,v+1,v);m&&t.push(m)}if(this.isLineLoop){let v=kl(this,e,sa,l,g-1,p,g-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function kl(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(oc.fromBufferAttribute(a,s),ac.fromBufferAttribute(a,r),t.distanceSqToSegment(oc,ac,Nh,Fp)>i)return;Nh.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Nh);if(!(c<e.near||c>e.far))return{distance:c,point:Fp.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Op=new W,Bp=new W,ga=class extends lc{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)Op.fromBufferAttribute(t,s),Bp.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Op.distanceTo(Bp);e.setAttribute("lineDistance",new Kt(i,1))}else Ye("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var _a=class extends ei{constructor(e=[],t=pr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var vs=class extends ei{constructor(e,t,i=Fi,s,r,o,a=In,l=In,c,u=_s,h=1){if(u!==_s&&u!==Ms)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ao(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},xa=class extends vs{constructor(e,t=Fi,i=pr,s,r,o=In,a=In,l,c=_s){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},va=class extends ei{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},fo=class n extends Un{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,p=0;g("z","y","x",-1,-1,i,t,e,o,r,0),g("z","y","x",1,-1,i,t,-e,o,r,1),g("x","z","y",1,1,e,i,t,s,o,2),g("x","z","y",1,-1,e,i,-t,s,o,3),g("x","y","z",1,-1,e,t,i,s,r,4),g("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Kt(c,3)),this.setAttribute("normal",new Kt(u,3)),this.setAttribute("uv",new Kt(h,2));function g(v,d,m,y,C,b,P,A,x,T,B){let D=b/x,I=P/T,k=b/2,V=P/2,N=A/2,H=x+1,$=T+1,G=0,le=0,J=new W;for(let j=0;j<$;j++){let ie=j*I-V;for(let fe=0;fe<H;fe++){let ue=fe*D-k;J[v]=ue*y,J[d]=ie*C,J[m]=N,c.push(J.x,J.y,J.z),J[v]=0,J[d]=0,J[m]=A>0?1:-1,u.push(J.x,J.y,J.z),h.push(fe/x),h.push(1-j/T),G+=1}}for(let j=0;j<T;j++)for(let ie=0;ie<x;ie++){let fe=f+ie+H*j,ue=f+ie+H*(j+1),Q=f+(ie+1)+H*(j+1),me=f+(ie+1)+H*j;l.push(fe,ue,me),l.push(ue,Q,me),le+=6}a.addGroup(p,le,B),p+=le,f+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Ui=class n extends Un{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],f=[],p=[],g=0,v=[],d=i/2,m=0;y(),o===!1&&(e>0&&C(!0),t>0&&C(!1)),this.setIndex(u),this.setAttribute("position",new Kt(h,3)),this.setAttribute("normal",new Kt(f,3)),this.setAttribute("uv",new Kt(p,2));function y(){let b=new W,P=new W,A=0,x=(t-e)/i;for(let T=0;T<=r;T++){let B=[],D=T/r,I=D*(t-e)+e;for(let k=0;k<=s;k++){let V=k/s,N=V*l+a,H=Math.sin(N),$=Math.cos(N);P.x=I*H,P.y=-D*i+d,P.z=I*$,h.push(P.x,P.y,P.z),b.set(H,x,$).normalize(),f.push(b.x,b.y,b.z),p.push(V,1-D),B.push(g++)}v.push(B)}for(let T=0;T<s;T++)for(let B=0;B<r;B++){let D=v[B][T],I=v[B+1][T],k=v[B+1][T+1],V=v[B][T+1];(e>0||B!==0)&&(u.push(D,I,V),A+=3),(t>0||B!==r-1)&&(u.push(I,k,V),A+=3)}c.addGroup(m,A,0),m+=A}function C(b){let P=g,A=new ut,x=new W,T=0,B=b===!0?e:t,D=b===!0?1:-1;for(let k=1;k<=s;k++)h.push(0,d*D,0),f.push(0,D,0),p.push(.5,.5),g++;let I=g;for(let k=0;k<=s;k++){let N=k/s*l+a,H=Math.cos(N),$=Math.sin(N);x.x=B*$,x.y=d*D,x.z=B*H,h.push(x.x,x.y,x.z),f.push(0,D,0),A.x=H*.5+.5,A.y=$*.5*D+.5,p.push(A.x,A.y),g++}for(let k=0;k<s;k++){let V=P+k,N=I+k;b===!0?u.push(N,N+1,V):u.push(N+1,N,V),T+=3}c.addGroup(m,T,b===!0?1:2),m+=T}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},ys=class n extends Ui{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var ur=class n extends Un{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,p=[],g=[],v=[],d=[];for(let m=0;m<u;m++){let y=m*f-o;for(let C=0;C<c;C++){let b=C*h-r;g.push(b,-y,0),v.push(0,0,1),d.push(C/a),d.push(1-m/l)}}for(let m=0;m<l;m++)for(let y=0;y<a;y++){let C=y+c*m,b=y+c*(m+1),P=y+1+c*(m+1),A=y+1+c*m;p.push(C,b,A),p.push(b,P,A)}this.setIndex(p),this.setAttribute("position",new Kt(g,3)),this.setAttribute("normal",new Kt(v,3)),this.setAttribute("uv",new Kt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Hs=class n extends Un{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new W,f=new W,p=[],g=[],v=[],d=[];for(let m=0;m<=i;m++){let y=[],C=m/i,b=o+C*a,P=e*Math.cos(b),A=Math.sqrt(e*e-P*P),x=0;m===0&&o===0?x=.5/t:m===i&&l===Math.PI&&(x=-.5/t);for(let T=0;T<=t;T++){let B=T/t,D=s+B*r;h.x=-A*Math.cos(D),h.y=P,h.z=A*Math.sin(D),g.push(h.x,h.y,h.z),f.copy(h).normalize(),v.push(f.x,f.y,f.z),d.push(B+x,1-C),y.push(c++)}u.push(y)}for(let m=0;m<i;m++)for(let y=0;y<t;y++){let C=u[m][y+1],b=u[m][y],P=u[m+1][y],A=u[m+1][y+1];(m!==0||o>0)&&p.push(C,b,A),(m!==i-1||l<Math.PI)&&p.push(b,P,A)}this.setIndex(p),this.setAttribute("position",new Kt(g,3)),this.setAttribute("normal",new Kt(v,3)),this.setAttribute("uv",new Kt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var ya=class n extends Un{constructor(e=1,t=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],f=new W,p=new W,g=new W;for(let v=0;v<=i;v++){let d=o+v/i*a;for(let m=0;m<=s;m++){let y=m/s*r;p.x=(e+t*Math.cos(d))*Math.cos(y),p.y=(e+t*Math.cos(d))*Math.sin(y),p.z=t*Math.sin(d),c.push(p.x,p.y,p.z),f.x=e*Math.cos(y),f.y=e*Math.sin(y),g.subVectors(p,f).normalize(),u.push(g.x,g.y,g.z),h.push(m/s),h.push(v/i)}}for(let v=1;v<=i;v++)for(let d=1;d<=s;d++){let m=(s+1)*v+d-1,y=(s+1)*(v-1)+d-1,C=(s+1)*(v-1)+d,b=(s+1)*v+d;l.push(m,y,b),l.push(y,C,b)}this.setIndex(l),this.setAttribute("position",new Kt(c,3)),this.setAttribute("normal",new Kt(u,3)),this.setAttribute("uv",new Kt(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};var Sa=class extends Di{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new Xe(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}};function gr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(kp(s))s.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(kp(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Vn(n){let e={};for(let t=0;t<n.length;t++){let i=gr(n[t]);for(let s in i)e[s]=i[s]}return e}function kp(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function By(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function mf(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:gt.workingColorSpace}var Nm={clone:gr,merge:Vn},ky=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,zy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ti=class extends Di{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=ky,this.fragmentShader=zy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=gr(e.uniforms),this.uniformsGroups=By(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new Xe().setHex(s.value);break;case"v2":this.uniforms[i].value=new ut().fromArray(s.value);break;case"v3":this.uniforms[i].value=new W().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Bt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new et().fromArray(s.value);break;case"m4":this.uniforms[i].value=new yt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},cc=class extends ti{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Ma=class extends Di{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Xe(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Xe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ba,this.normalScale=new ut(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ji,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var ba=class extends Di{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Xe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Xe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ba,this.normalScale=new ut(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ji,this.combine=wc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},uc=class extends Di{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=xm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},hc=class extends Di{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function eo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function zl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Ws=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},fc=class extends Ws{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Fh,endingEnd:Fh}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Oh:r=e,a=2*t-i;break;case Bh:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Oh:o=e,l=2*i-t;break;case Bh:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,p=this._weightNext,g=(i-t)/(s-t),v=g*g,d=v*g,m=-f*d+2*f*v-f*g,y=(1+f)*d+(-1.5-2*f)*v+(-.5+f)*g+1,C=(-1-p)*d+(1.5+p)*v+.5*g,b=p*d-p*v;for(let P=0;P!==a;++P)r[P]=m*o[u+P]+y*o[c+P]+C*o[l+P]+b*o[h+P];return r}},dc=class extends Ws{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},pc=class extends Ws{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},mc=class extends Ws{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let g=(i-t)/(s-t),v=1-g;for(let d=0;d!==a;++d)r[d]=o[c+d]*v+o[l+d]*g;return r}let f=a*2,p=e-1;for(let g=0;g!==a;++g){let v=o[c+g],d=o[l+g],m=p*f+g*2,y=h[m],C=h[m+1],b=e*f+g*2,P=u[b],A=u[b+1],x=Gy(i,t,y,P,s);r[g]=Dm(x,v,C,A,d)}return r}};function Dm(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function Vy(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function Gy(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=Dm(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Vy(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var hi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=eo(t,this.TimeBufferType),this.values=eo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:eo(e.times,Array),values:eo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),zl(e.settings)&&(i.settings={inTangents:eo(e.settings.inTangents,Array),outTangents:eo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new pc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new dc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new fc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new mc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case oa:t=this.InterpolantFactoryMethodDiscrete;break;case ec:t=this.InterpolantFactoryMethodLinear;break;case Hl:t=this.InterpolantFactoryMethodSmooth;break;case Uh:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ye("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return oa;case this.InterpolantFactoryMethodLinear:return ec;case this.InterpolantFactoryMethodSmooth:return Hl;case this.InterpolantFactoryMethodBezier:return Uh}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;zl(this.settings)&&(zp(this.settings.inTangents,e),zp(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;zl(this.settings)&&(Vp(this.settings.inTangents,e),Vp(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(je("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(je("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){je("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){je("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&my(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){je("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Hl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,f=h-i,p=h+i;for(let g=0;g!==i;++g){let v=t[h+g];if(v!==t[f+g]||v!==t[p+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,f=o*i;for(let p=0;p!==i;++p)t[f+p]=t[h+p]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,zl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function zp(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function Vp(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}hi.prototype.ValueTypeName="";hi.prototype.TimeBufferType=Float32Array;hi.prototype.ValueBufferType=Float32Array;hi.prototype.DefaultInterpolation=ec;var Xs=class extends hi{constructor(e,t,i){super(e,t,i)}};Xs.prototype.ValueTypeName="bool";Xs.prototype.ValueBufferType=Array;Xs.prototype.DefaultInterpolation=oa;Xs.prototype.InterpolantFactoryMethodLinear=void 0;Xs.prototype.InterpolantFactoryMethodSmooth=void 0;var gc=class extends hi{constructor(e,t,i,s){super(e,t,i,s)}};gc.prototype.ValueTypeName="color";var _c=class extends hi{constructor(e,t,i,s){super(e,t,i,s)}};_c.prototype.ValueTypeName="number";var xc=class extends Ws{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Nn.slerpFlat(r,0,o,c-a,o,c,l);return r}},wa=class extends hi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new xc(this.times,this.values,this.getValueSize(),e)}};wa.prototype.ValueTypeName="quaternion";wa.prototype.InterpolantFactoryMethodSmooth=void 0;var qs=class extends hi{constructor(e,t,i){super(e,t,i)}};qs.prototype.ValueTypeName="string";qs.prototype.ValueBufferType=Array;qs.prototype.DefaultInterpolation=oa;qs.prototype.InterpolantFactoryMethodLinear=void 0;qs.prototype.InterpolantFactoryMethodSmooth=void 0;var vc=class extends hi{constructor(e,t,i,s){super(e,t,i,s)}};vc.prototype.ValueTypeName="vector";var yc=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let p=c[h],g=c[h+1];if(p.global&&(p.lastIndex=0),p.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Um=new yc,Sc=class{constructor(e){this.manager=e!==void 0?e:Um,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Sc.DEFAULT_MATERIAL_NAME="__DEFAULT";var po=class extends Dn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Xe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Ta=class extends po{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Dn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Xe(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Dh=new yt,Gp=new W,Hp=new W,Mc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ut(512,512),this.mapType=zn,this.map=null,this.mapPass=null,this.matrix=new yt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Gs,this._frameExtents=new ut(1,1),this._viewportCount=1,this._viewports=[new Bt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Gp.setFromMatrixPosition(e.matrixWorld),t.position.copy(Gp),Hp.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Hp),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){Dh.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Dh,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===ro||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Dh)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Vl=new W,Gl=new Nn,Zi=new W,Aa=class extends Dn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new yt,this.projectionMatrix=new yt,this.projectionMatrixInverse=new yt,this.coordinateSystem=yi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Vl,Gl,Zi),Zi.x===1&&Zi.y===1&&Zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Vl,Gl,Zi.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Vl,Gl,Zi),Zi.x===1&&Zi.y===1&&Zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Vl,Gl,Zi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},ks=new W,Wp=new ut,Xp=new ut,Zn=class extends Aa{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=tc*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(fh*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return tc*2*Math.atan(Math.tan(fh*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){ks.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(ks.x,ks.y).multiplyScalar(-e/ks.z),ks.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(ks.x,ks.y).multiplyScalar(-e/ks.z)}getViewSize(e,t){return this.getViewBounds(e,Wp,Xp),t.subVectors(Xp,Wp)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(fh*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ea=class extends Aa{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},kh=class extends Mc{constructor(){super(new Ea(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},mo=class extends po{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Dn.DEFAULT_UP),this.updateMatrix(),this.target=new Dn,this.shadow=new kh}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},Ca=class extends po{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var to=-90,no=1,go=class extends Dn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Zn(to,no,e,t);s.layers=this.layers,this.add(s);let r=new Zn(to,no,e,t);r.layers=this.layers,this.add(r);let o=new Zn(to,no,e,t);o.layers=this.layers,this.add(o);let a=new Zn(to,no,e,t);a.layers=this.layers,this.add(a);let l=new Zn(to,no,e,t);l.layers=this.layers,this.add(l);let c=new Zn(to,no,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===yi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===ro)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let v=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let d=!1;e.isWebGLRenderer===!0?d=e.state.buffers.depth.getReversed():d=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=v,e.setRenderTarget(i,5,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,f,p),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},bc=class extends Zn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var gf="\\[\\]\\.:\\/",Hy=new RegExp("["+gf+"]","g"),_f="[^"+gf+"]",Wy="[^"+gf.replace("\\.","")+"]",Xy=/((?:WC+[\/:])*)/.source.replace("WC",_f),qy=/(WCOD+)?/.source.replace("WCOD",Wy),$y=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",_f),Yy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",_f),Zy=new RegExp("^"+Xy+qy+$y+Yy+"$"),Jy=["material","materials","bones","map"],zh=class{constructor(e,t,i){let s=i||Wt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Wt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Hy,"")}static parseTrackName(e){let t=Zy.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Jy.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){je("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){je("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){je("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){je("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){je("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){je("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){je("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;je("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){je("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){je("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Wt.Composite=zh;Wt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Wt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Wt.prototype.GetterByBindingType=[Wt.prototype._getValue_direct,Wt.prototype._getValue_array,Wt.prototype._getValue_arrayElement,Wt.prototype._getValue_toArray];Wt.prototype.SetterByBindingTypeAndVersioning=[[Wt.prototype._setValue_direct,Wt.prototype._setValue_direct_setNeedsUpdate,Wt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Wt.prototype._setValue_array,Wt.prototype._setValue_array_setNeedsUpdate,Wt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Wt.prototype._setValue_arrayElement,Wt.prototype._setValue_arrayElement_setNeedsUpdate,Wt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Wt.prototype._setValue_fromArray,Wt.prototype._setValue_fromArray_setNeedsUpdate,Wt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var RC=new Float32Array(1);var qp=new yt,Ra=class{constructor(e,t,i=0,s=1/0){this.ray=new uo(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new lo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):je("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return qp.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(qp),this}intersectObject(e,t=!0,i=[]){return Vh(e,this,i,t),i.sort($p),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)Vh(e[s],this,i,t);return i.sort($p),i}};function $p(n,e){return n.distance-e.distance}function Vh(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Vh(r[o],e,t,!0)}}var Gh=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};function xf(n,e,t,i){let s=Ky(i);switch(t){case af:return n*e;case So:return n*e/s.components*s.byteLength;case Ic:return n*e/s.components*s.byteLength;case Bi:return n*e*2/s.components*s.byteLength;case Lc:return n*e*2/s.components*s.byteLength;case lf:return n*e*3/s.components*s.byteLength;case ni:return n*e*4/s.components*s.byteLength;case Nc:return n*e*4/s.components*s.byteLength;case La:case Na:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Da:case Ua:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Uc:case Oc:return Math.max(n,16)*Math.max(e,8)/4;case Dc:case Fc:return Math.max(n,8)*Math.max(e,8)/2;case Bc:case kc:case Vc:case Gc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case zc:case Fa:case Hc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Wc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Xc:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case qc:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case $c:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Yc:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Zc:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Jc:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Kc:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case jc:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Qc:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case eu:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case tu:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case nu:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case iu:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case su:case ru:case ou:return Math.ceil(n/4)*Math.ceil(e/4)*16;case au:case lu:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Oa:case cu:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Ky(n){switch(n){case zn:case nf:return{byteLength:1,components:1};case yo:case sf:case Oi:return{byteLength:2,components:1};case Rc:case Pc:return{byteLength:2,components:4};case Fi:case Cc:case Si:return{byteLength:4,components:1};case rf:case of:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function ig(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function Qy(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((p,g)=>p.start-g.start);let f=0;for(let p=1;p<h.length;p++){let g=h[f],v=h[p];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++f,h[f]=v)}h.length=f+1;for(let p=0,g=h.length;p<g;p++){let v=h[p];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var eS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,tS=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,nS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,iS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,sS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,rS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,oS=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,aS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,lS=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,cS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,uS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,hS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,fS=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,dS=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,pS=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,mS=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,gS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,_S=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,xS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,vS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,yS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,SS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,MS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,bS=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,wS=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,TS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,AS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ES=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,CS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,RS="gl_FragColor = linearToOutputTexel( gl_FragColor );",PS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,IS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,LS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,NS=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,DS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,US=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,FS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,OS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,BS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,kS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,zS=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,VS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,GS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,HS=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,WS=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,XS=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,qS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,$S=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,YS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,ZS=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,JS=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,KS=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,jS=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,QS=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,eM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,tM=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,nM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,iM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,sM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,rM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,oM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,aM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,lM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,cM=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,uM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,hM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,fM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,dM=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,pM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,mM=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,gM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,_M=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,xM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,vM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,yM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,SM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,MM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,bM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,wM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,TM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,AM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,EM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,CM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,RM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,PM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,IM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,LM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,NM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,DM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,UM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,FM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,OM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,BM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,kM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,zM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,VM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,GM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,HM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,WM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,XM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,qM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,$M=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,YM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,ZM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,JM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,KM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,jM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,QM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,eb=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,tb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,nb=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ib=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,sb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,rb=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,ob=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,ab=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,lb=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,cb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,ub=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,hb=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,fb=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,db=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,pb=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mb=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,gb=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,_b=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,xb=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,vb=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,yb=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Sb=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Mb=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,bb=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,wb=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Tb=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Ab=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Eb=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Cb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Rb=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Pb=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ib=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Lb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,lt={alphahash_fragment:eS,alphahash_pars_fragment:tS,alphamap_fragment:nS,alphamap_pars_fragment:iS,alphatest_fragment:sS,alphatest_pars_fragment:rS,aomap_fragment:oS,aomap_pars_fragment:aS,batching_pars_vertex:lS,batching_vertex:cS,begin_vertex:uS,beginnormal_vertex:hS,bsdfs:fS,iridescence_fragment:dS,bumpmap_pars_fragment:pS,clipping_planes_fragment:mS,clipping_planes_pars_fragment:gS,clipping_planes_pars_vertex:_S,clipping_planes_vertex:xS,color_fragment:vS,color_pars_fragment:yS,color_pars_vertex:SS,color_vertex:MS,common:bS,defaultnormal_vertex:wS,displacementmap_pars_vertex:TS,displacementmap_vertex:AS,emissivemap_fragment:ES,emissivemap_pars_fragment:CS,colorspace_fragment:RS,colorspace_pars_fragment:PS,envmap_fragment:IS,envmap_common_pars_fragment:LS,envmap_pars_fragment:NS,envmap_pars_vertex:DS,envmap_physical_pars_fragment:XS,envmap_vertex:US,fog_vertex:FS,fog_pars_vertex:OS,fog_fragment:BS,fog_pars_fragment:kS,gradientmap_pars_fragment:zS,lightmap_pars_fragment:VS,lights_lambert_fragment:GS,lights_lambert_pars_fragment:HS,lights_pars_begin:WS,lights_toon_fragment:qS,lights_toon_pars_fragment:$S,lights_phong_fragment:YS,lights_phong_pars_fragment:ZS,lights_physical_fragment:JS,lights_physical_pars_fragment:KS,lights_fragment_begin:jS,lights_fragment_maps:QS,lights_fragment_end:eM,lightprobes_pars_fragment:tM,logdepthbuf_fragment:nM,logdepthbuf_pars_fragment:iM,logdepthbuf_pars_vertex:sM,logdepthbuf_vertex:rM,map_fragment:oM,map_pars_fragment:aM,map_particle_fragment:lM,map_particle_pars_fragment:cM,metalnessmap_fragment:uM,metalnessmap_pars_fragment:hM,morphinstance_vertex:fM,morphcolor_vertex:dM,morphnormal_vertex:pM,morphtarget_pars_vertex:mM,morphtarget_vertex:gM,normal_fragment_begin:_M,normal_fragment_maps:xM,normal_pars_fragment:vM,normal_pars_vertex:yM,normal_vertex:SM,normalmap_pars_fragment:MM,clearcoat_normal_fragment_begin:bM,clearcoat_normal_fragment_maps:wM,clearcoat_pars_fragment:TM,iridescence_pars_fragment:AM,opaque_fragment:EM,packing:CM,premultiplied_alpha_fragment:RM,project_vertex:PM,dithering_fragment:IM,dithering_pars_fragment:LM,roughnessmap_fragment:NM,roughnessmap_pars_fragment:DM,shadowmap_pars_fragment:UM,shadowmap_pars_vertex:FM,shadowmap_vertex:OM,shadowmask_pars_fragment:BM,skinbase_vertex:kM,skinning_pars_vertex:zM,skinning_vertex:VM,skinnormal_vertex:GM,specularmap_fragment:HM,specularmap_pars_fragment:WM,tonemapping_fragment:XM,tonemapping_pars_fragment:qM,transmission_fragment:$M,transmission_pars_fragment:YM,uv_pars_fragment:ZM,uv_pars_vertex:JM,uv_vertex:KM,worldpos_vertex:jM,background_vert:QM,background_frag:eb,backgroundCube_vert:tb,backgroundCube_frag:nb,cube_vert:ib,cube_frag:sb,depth_vert:rb,depth_frag:ob,distance_vert:ab,distance_frag:lb,equirect_vert:cb,equirect_frag:ub,linedashed_vert:hb,linedashed_frag:fb,meshbasic_vert:db,meshbasic_frag:pb,meshlambert_vert:mb,meshlambert_frag:gb,meshmatcap_vert:_b,meshmatcap_frag:xb,meshnormal_vert:vb,meshnormal_frag:yb,meshphong_vert:Sb,meshphong_frag:Mb,meshphysical_vert:bb,meshphysical_frag:wb,meshtoon_vert:Tb,meshtoon_frag:Ab,points_vert:Eb,points_frag:Cb,shadow_vert:Rb,shadow_frag:Pb,sprite_vert:Ib,sprite_frag:Lb},Le={common:{diffuse:{value:new Xe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new ut(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Xe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Xe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new Xe(16777215)},opacity:{value:1},center:{value:new ut(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}},is={basic:{uniforms:Vn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:lt.meshbasic_vert,fragmentShader:lt.meshbasic_frag},lambert:{uniforms:Vn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new Xe(0)},envMapIntensity:{value:1}}]),vertexShader:lt.meshlambert_vert,fragmentShader:lt.meshlambert_frag},phong:{uniforms:Vn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new Xe(0)},specular:{value:new Xe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:lt.meshphong_vert,fragmentShader:lt.meshphong_frag},standard:{uniforms:Vn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new Xe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:lt.meshphysical_vert,fragmentShader:lt.meshphysical_frag},toon:{uniforms:Vn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new Xe(0)}}]),vertexShader:lt.meshtoon_vert,fragmentShader:lt.meshtoon_frag},matcap:{uniforms:Vn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:lt.meshmatcap_vert,fragmentShader:lt.meshmatcap_frag},points:{uniforms:Vn([Le.points,Le.fog]),vertexShader:lt.points_vert,fragmentShader:lt.points_frag},dashed:{uniforms:Vn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:lt.linedashed_vert,fragmentShader:lt.linedashed_frag},depth:{uniforms:Vn([Le.common,Le.displacementmap]),vertexShader:lt.depth_vert,fragmentShader:lt.depth_frag},normal:{uniforms:Vn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:lt.meshnormal_vert,fragmentShader:lt.meshnormal_frag},sprite:{uniforms:Vn([Le.sprite,Le.fog]),vertexShader:lt.sprite_vert,fragmentShader:lt.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:lt.background_vert,fragmentShader:lt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:lt.backgroundCube_vert,fragmentShader:lt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:lt.cube_vert,fragmentShader:lt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:lt.equirect_vert,fragmentShader:lt.equirect_frag},distance:{uniforms:Vn([Le.common,Le.displacementmap,{referencePosition:{value:new W},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:lt.distance_vert,fragmentShader:lt.distance_frag},shadow:{uniforms:Vn([Le.lights,Le.fog,{color:{value:new Xe(0)},opacity:{value:1}}]),vertexShader:lt.shadow_vert,fragmentShader:lt.shadow_frag}};is.physical={uniforms:Vn([is.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new ut(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new et},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new Xe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new ut},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new Xe(0)},specularColor:{value:new Xe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new ut},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:lt.meshphysical_vert,fragmentShader:lt.meshphysical_frag};var uu={r:0,b:0,g:0},Nb=new yt,sg=new et;sg.set(-1,0,0,0,1,0,0,0,1);function Db(n,e,t,i,s,r){let o=new Xe(0),a=s===!0?0:1,l,c,u=null,h=0,f=null;function p(y){let C=y.isScene===!0?y.background:null;if(C&&C.isTexture){let b=y.backgroundBlurriness>0;C=e.get(C,b)}return C}function g(y){let C=!1,b=p(y);b===null?d(o,a):b&&b.isColor&&(d(b,1),C=!0);let P=n.xr.getEnvironmentBlendMode();P==="additive"?t.buffers.color.setClear(0,0,0,1,r):P==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||C)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(y,C){let b=p(C);b&&b.isCubeTexture?(c===void 0&&(c=new kt(new fo(1,1,1),new ti({name:"BackgroundCubeMaterial",uniforms:gr(is.backgroundCube.uniforms),vertexShader:is.backgroundCube.vertexShader,fragmentShader:is.backgroundCube.fragmentShader,side:Kn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,A,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Nb.makeRotationFromEuler(C.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(sg),c.material.toneMapped=gt.getTransfer(b.colorSpace)!==Tt,(u!==b||h!==b.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,f=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new kt(new ur(2,2),new ti({name:"BackgroundMaterial",uniforms:gr(is.background.uniforms),vertexShader:is.background.vertexShader,fragmentShader:is.background.fragmentShader,side:$s,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=gt.getTransfer(b.colorSpace)!==Tt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,f=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function d(y,C){y.getRGB(uu,mf(n)),t.buffers.color.setClear(uu.r,uu.g,uu.b,C,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,C=1){o.set(y),a=C,d(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,d(o,a)},render:g,addToRenderList:v,dispose:m}}function Ub(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(I,k,V,N,H){let $=!1,G=h(I,N,V,k);r!==G&&(r=G,c(r.object)),$=p(I,N,V,H),$&&g(I,N,V,H),H!==null&&e.update(H,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,b(I,k,V,N),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function h(I,k,V,N){let H=N.wireframe===!0,$=i[k.id];$===void 0&&($={},i[k.id]=$);let G=I.isInstancedMesh===!0?I.id:0,le=$[G];le===void 0&&(le={},$[G]=le);let J=le[V.id];J===void 0&&(J={},le[V.id]=J);let j=J[H];return j===void 0&&(j=f(l()),J[H]=j),j}function f(I){let k=[],V=[],N=[];for(let H=0;H<t;H++)k[H]=0,V[H]=0,N[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:V,attributeDivisors:N,object:I,attributes:{},index:null}}function p(I,k,V,N){let H=r.attributes,$=k.attributes,G=0,le=V.getAttributes();for(let J in le)if(le[J].location>=0){let ie=H[J],fe=$[J];if(fe===void 0&&(J==="instanceMatrix"&&I.instanceMatrix&&(fe=I.instanceMatrix),J==="instanceColor"&&I.instanceColor&&(fe=I.instanceColor)),ie===void 0||ie.attribute!==fe||fe&&ie.data!==fe.data)return!0;G++}return r.attributesNum!==G||r.index!==N}function g(I,k,V,N){let H={},$=k.attributes,G=0,le=V.getAttributes();for(let J in le)if(le[J].location>=0){let ie=$[J];ie===void 0&&(J==="instanceMatrix"&&I.instanceMatrix&&(ie=I.instanceMatrix),J==="instanceColor"&&I.instanceColor&&(ie=I.instanceColor));let fe={};fe.attribute=ie,ie&&ie.data&&(fe.data=ie.data),H[J]=fe,G++}r.attributes=H,r.attributesNum=G,r.index=N}function v(){let I=r.newAttributes;for(let k=0,V=I.length;k<V;k++)I[k]=0}function d(I){m(I,0)}function m(I,k){let V=r.newAttributes,N=r.enabledAttributes,H=r.attributeDivisors;V[I]=1,N[I]===0&&(n.enableVertexAttribArray(I),N[I]=1),H[I]!==k&&(n.vertexAttribDivisor(I,k),H[I]=k)}function y(){let I=r.newAttributes,k=r.enabledAttributes;for(let V=0,N=k.length;V<N;V++)k[V]!==I[V]&&(n.disableVertexAttribArray(V),k[V]=0)}function C(I,k,V,N,H,$,G){G===!0?n.vertexAttribIPointer(I,k,V,H,$):n.vertexAttribPointer(I,k,V,N,H,$)}function b(I,k,V,N){v();let H=N.attributes,$=V.getAttributes(),G=k.defaultAttributeValues;for(let le in $){let J=$[le];if(J.location>=0){let j=H[le];if(j===void 0&&(le==="instanceMatrix"&&I.instanceMatrix&&(j=I.instanceMatrix),le==="instanceColor"&&I.instanceColor&&(j=I.instanceColor)),j!==void 0){let ie=j.normalized,fe=j.itemSize,ue=e.get(j);if(ue===void 0)continue;let Q=ue.buffer,me=ue.type,xe=ue.bytesPerElement,Ee=me===n.INT||me===n.UNSIGNED_INT||j.gpuType===Cc;if(j.isInterleavedBufferAttribute){let Me=j.data,He=Me.isInterleavedBuffer===!0?Me.stride:Me.itemSize,it=j.offset;if(Me.isInstancedInterleavedBuffer||Me.isInstancedBufferAttribute){for(let Ve=0;Ve<J.locationSize;Ve++)m(J.location+Ve,Me.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Me.meshPerAttribute*Me.count)}else for(let Ve=0;Ve<J.locationSize;Ve++)d(J.location+Ve);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let Ve=0;Ve<J.locationSize;Ve++)C(J.location+Ve,fe/J.locationSize,me,ie,He*xe,(it+fe/J.locationSize*Ve)*xe,Ee)}else{if(j.isInstancedBufferAttribute){for(let Me=0;Me<J.locationSize;Me++)m(J.location+Me,j.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let Me=0;Me<J.locationSize;Me++)d(J.location+Me);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let Me=0;Me<J.locationSize;Me++)C(J.location+Me,fe/J.locationSize,me,ie,fe*xe,fe/J.locationSize*Me*xe,Ee)}}else if(G!==void 0){let ie=G[le];if(ie!==void 0)switch(ie.length){case 2:n.vertexAttrib2fv(J.location,ie);break;case 3:n.vertexAttrib3fv(J.location,ie);break;case 4:n.vertexAttrib4fv(J.location,ie);break;default:n.vertexAttrib1fv(J.location,ie)}}}}y()}function P(){B();for(let I in i){let k=i[I];for(let V in k){let N=k[V];for(let H in N){let $=N[H];for(let G in $)u($[G].object),delete $[G];delete N[H]}}delete i[I]}}function A(I){if(i[I.id]===void 0)return;let k=i[I.id];for(let V in k){let N=k[V];for(let H in N){let $=N[H];for(let G in $)u($[G].object),delete $[G];delete N[H]}}delete i[I.id]}function x(I){for(let k in i){let V=i[k];for(let N in V){let H=V[N];if(H[I.id]===void 0)continue;let $=H[I.id];for(let G in $)u($[G].object),delete $[G];delete H[I.id]}}}function T(I){for(let k in i){let V=i[k],N=I.isInstancedMesh===!0?I.id:0,H=V[N];if(H!==void 0){for(let $ in H){let G=H[$];for(let le in G)u(G[le].object),delete G[le];delete H[$]}delete V[N],Object.keys(V).length===0&&delete i[k]}}}function B(){D(),o=!0,r!==s&&(r=s,c(r.object))}function D(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:D,dispose:P,releaseStatesOfGeometry:A,releaseStatesOfObject:T,releaseStatesOfProgram:x,initAttributes:v,enableAttribute:d,disableUnusedAttributes:y}}function Fb(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let f=0;for(let p=0;p<u;p++)f+=c[p];t.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Ob(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==ni&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let T=x===Oi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==zn&&x!==Si&&!T&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ye("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Ye("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),d=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),C=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),P=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:p,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:d,maxAttributes:m,maxVertexUniforms:y,maxVaryings:C,maxFragmentUniforms:b,maxSamples:P,samples:A}}function Bb(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Ni,a=new et,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let p=h.length!==0||f||i!==0||s;return s=f,i=h.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,p){let g=h.clippingPlanes,v=h.clipIntersection,d=h.clipShadows,m=n.get(h);if(!s||g===null||g.length===0||r&&!d)r?u(null):c();else{let y=r?0:i,C=y*4,b=m.clippingState||null;l.value=b,b=u(g,f,C,p);for(let P=0;P!==C;++P)b[P]=t[P];m.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,f,p,g){let v=h!==null?h.length:0,d=null;if(v!==0){if(d=l.value,g!==!0||d===null){let m=p+v*4,y=f.matrixWorldInverse;a.getNormalMatrix(y),(d===null||d.length<m)&&(d=new Float32Array(m));for(let C=0,b=p;C!==v;++C,b+=4)o.copy(h[C]).applyMatrix4(y,a),o.normal.toArray(d,b),d[b+3]=o.constant}l.value=d,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,d}}var Ga=class extends ui{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new _a(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new fo(5,5,5),r=new ti({name:"CubemapFromEquirect",uniforms:gr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Kn,blending:fr});r.uniforms.tEquirect.value=t;let o=new kt(s,r),a=t.minFilter;return t.minFilter===Ss&&(t.minFilter=Jn),new go(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},Fm=256,kb=3,zb=20,rg=256,og=16,Vb=3,Gb=new W,Hb=new Xe,fu=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new go(1,10,null),this._boxMesh=new kt(new fo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=Gb}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,p=l.autoClearDepth,g=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(Hb));let d=new go(i,s,u);return d.position.copy(a),d.update(l,e),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=p,l.autoClearStencil=g,e.background=v,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=km(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Bm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Fm,Im(e))}_fromTexture(e,t){e.mapping===pr||e.mapping===vo?this._setSize(e.image.length===0?Fm:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Om(e,!1,!1),i=Math.log2(e)-kb;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Om(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===pr||e.mapping===vo?(this._cubemapMaterial===null&&(this._cubemapMaterial=km()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Bm()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=Wb(),this._integrationMaterial=Xb());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/og);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-Vb)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(rg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=qb());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function Om(n,e,t){return new Ga(n,{minFilter:Ss,generateMipmaps:e,type:Oi,colorSpace:aa,depthBuffer:t})}function Ha(n,e,t){return new ti({name:n,uniforms:e,vertexShader:lt.cube_vert,fragmentShader:t,side:Kn,blending:fr,depthTest:!1,depthWrite:!1})}function Wb(){return Ha("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${rg}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Xb(){return Ha("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:og}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function qb(){return Ha("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${zb}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Bm(){return Ha("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function km(){return Ha("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function $b(n){let e=new WeakMap,t=new WeakMap,i=null;function s(f,p=!1){return f==null?null:p?o(f):r(f)}function r(f){if(f&&f.isTexture){let p=f.mapping;if(p===Tc||p===Ac)if(e.has(f)){let g=e.get(f).texture;return a(g,f.mapping)}else{let g=f.image;if(g&&g.height>0){let v=new Ga(g.height);return v.fromEquirectangularTexture(n,f),e.set(f,v),f.addEventListener("dispose",c),a(v.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let p=f.mapping,g=p===Tc||p===Ac,v=p===pr||p===vo;if(g||v){let d=t.get(f),m=d!==void 0?d.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==m)return i===null&&(i=new fu(n)),d=g?i.fromEquirectangular(f,d):i.fromCubemap(f,d),d.texture.pmremVersion=f.pmremVersion,t.set(f,d),d.texture;if(d!==void 0)return d.texture;{let y=f.image;return g&&y&&y.height>0||v&&y&&l(y)?(i===null&&(i=new fu(n)),d=g?i.fromEquirectangular(f):i.fromCubemap(f),d.texture.pmremVersion=f.pmremVersion,t.set(f,d),f.addEventListener("dispose",u),d.texture):null}}}return f}function a(f,p){return p===Tc?f.mapping=pr:p===Ac&&(f.mapping=vo),f}function l(f){let p=0,g=6;for(let v=0;v<g;v++)f[v]!==void 0&&p++;return p===g}function c(f){let p=f.target;p.removeEventListener("dispose",c);let g=e.get(p);g!==void 0&&(e.delete(p),g.dispose())}function u(f){let p=f.target;p.removeEventListener("dispose",u);let g=t.get(p);g!==void 0&&(t.delete(p),g.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function Yb(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&ra("WebGLRenderer: "+i+" extension not supported."),s}}}function Zb(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let d in g.attributes)e.remove(g.attributes[d]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let v=r.get(g);v&&(e.remove(v),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function u(g){let v=g.attributes;for(let d in v)e.update(v[d],n.ARRAY_BUFFER)}function h(g){let v=g.index,d=g.attributes.position,m=0;if(d===void 0)return;let y=v!==null?v.array.length:d.array.length/3-1,C=d.count>=65535?da:fa,b=new C(Math.ceil(y/3)*6,1),P=b.array;if(v!==null){let x=v.array;m=v.version;for(let T=0,B=0;T<y;T+=3){let D=x[T+0],I=x[T+1],k=x[T+2];P[B++]=D,P[B++]=I,P[B++]=I,P[B++]=k,P[B++]=k,P[B++]=D}}else{m=d.version;for(let x=0,T=0;x<y;x+=3){let B=x+0,D=x+1,I=x+2;P[T++]=B,P[T++]=D,P[T++]=D,P[T++]=I,P[T++]=I,P[T++]=B}}b.version=m;let A=r.get(g);A&&e.remove(A),r.set(g,b)}function f(g){let v=r.get(g);if(v){let d=g.index;d!==null&&v.version<d.version&&h(g)}else h(g);return r.get(g)}function p(){for(let g in s){let v=s[g].deref();v!==void 0&&l(v)}}return{get:c,update:u,getWireframeAttribute:f,dispose:p}}function Jb(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,f){n.drawElements(i,f,r,h*o),t.update(f,i,1)}function c(h,f,p){p!==0&&(n.drawElementsInstanced(i,f,r,h*o,p),t.update(f,i,p))}function u(h,f,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,h,0,p);let v=0;for(let d=0;d<p;d++)v+=f[d];t.update(v,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function Kb(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:je("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function jb(n,e,t){let i=new WeakMap,s=new Bt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let B=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",B)};f!==void 0&&f.texture.dispose();let p=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,d=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],C=0;p===!0&&(C=1),g===!0&&(C=2),v===!0&&(C=3);let b=a.attributes.position.count*C,P=1;b>e.maxTextureSize&&(P=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let A=new Float32Array(b*P*4*h),x=new ua(A,b,P,h);x.type=Si,x.needsUpdate=!0;let T=C*4;for(let D=0;D<h;D++){let I=d[D],k=m[D],V=y[D],N=b*P*4*D;for(let H=0;H<I.count;H++){let $=H*T;p===!0&&(s.fromBufferAttribute(I,H),A[N+$+0]=s.x,A[N+$+1]=s.y,A[N+$+2]=s.z,A[N+$+3]=0),g===!0&&(s.fromBufferAttribute(k,H),A[N+$+4]=s.x,A[N+$+5]=s.y,A[N+$+6]=s.z,A[N+$+7]=0),v===!0&&(s.fromBufferAttribute(V,H),A[N+$+8]=s.x,A[N+$+9]=s.y,A[N+$+10]=s.z,A[N+$+11]=V.itemSize===4?s.w:1)}}f={count:h,texture:x,size:new ut(b,P)},i.set(a,f),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let p=0;for(let v=0;v<c.length;v++)p+=c[v];let g=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function Qb(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,f=e.get(c,h);if(r.get(f)!==u&&(e.update(f),r.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==u&&(p.update(),r.set(p,u))}return f}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var ew={[Zh]:"LINEAR_TONE_MAPPING",[Jh]:"REINHARD_TONE_MAPPING",[Kh]:"CINEON_TONE_MAPPING",[jh]:"ACES_FILMIC_TONE_MAPPING",[ef]:"AGX_TONE_MAPPING",[Pa]:"NEUTRAL_TONE_MAPPING",[Qh]:"CUSTOM_TONE_MAPPING"};function tw(n,e,t,i,s,r){let o=new ui(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Un;u.setAttribute("position",new Kt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Kt([0,2,0,0,2,0],2));let h=new cc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new kt(u,h),p=new Ea(-1,1,1,-1,0,1),g=null,v=null,d=!1,m,y=null,C=[],b=!1;this.setSize=function(P,A){o.setSize(P,A),a!==null&&a.setSize(P,A),l!==null&&l.setSize(P,A);for(let x=0;x<C.length;x++){let T=C[x];T.setSize&&T.setSize(P,A)}},this.setEffects=function(P){C=P,b=C.length>0&&C[0].isRenderPass===!0;let A=o.width,x=o.height;C.length>0&&a===null&&(a=new ui(A,x,{type:Oi,depthBuffer:!1,stencilBuffer:!1}),l=new ui(A,x,{type:Oi,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&C.some(B=>B.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new vs(A,x),r===!0&&(c.format=Ms,c.type=mr)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let B=0;B<C.length;B++){let D=C[B];D.setSize&&D.setSize(A,x),T&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(c)}},this.begin=function(P,A){if(d||P.toneMapping===ts&&C.length===0)return!1;if(y=A,A!==null){let x=A.width,T=A.height;(o.width!==x||o.height!==T)&&this.setSize(x,T)}return b===!1&&P.setRenderTarget(o),m=P.toneMapping,P.toneMapping=ts,!0},this.hasRenderPass=function(){return b},this.end=function(P,A){P.toneMapping=m,d=!0;let x=o,T=a;for(let B=0;B<C.length;B++){let D=C[B];D.enabled!==!1&&(D.render(P,T,x,A),D.needsSwap!==!1&&(x=T,T=T===a?l:a))}if(g!==P.outputColorSpace||v!==P.toneMapping){g=P.outputColorSpace,v=P.toneMapping,h.defines={},gt.getTransfer(g)===Tt&&(h.defines.SRGB_TRANSFER="");let B=ew[v];B&&(h.defines[B]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=x.texture,P.setRenderTarget(y),P.render(f,p),y=null,d=!1},this.isCompositing=function(){return d},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var ag=new ei,lg=new vs(1,1),cg=new xa(1),ug=new ua,hg=new sc,fg=new _a,zm=[],Vm=[],Gm=new Float32Array(16),Hm=new Float32Array(9),Wm=new Float32Array(4);function bo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=zm[s];if(r===void 0&&(r=new Float32Array(s),zm[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Sn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Mn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function pu(n,e){let t=Vm[e];t===void 0&&(t=new Int32Array(e),Vm[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function nw(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function iw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2fv(this.addr,e),Mn(t,e)}}function sw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Sn(t,e))return;n.uniform3fv(this.addr,e),Mn(t,e)}}function rw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4fv(this.addr,e),Mn(t,e)}}function ow(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,i))return;Wm.set(i),n.uniformMatrix2fv(this.addr,!1,Wm),Mn(t,i)}}function aw(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,i))return;Hm.set(i),n.uniformMatrix3fv(this.addr,!1,Hm),Mn(t,i)}}function lw(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,i))return;Gm.set(i),n.uniformMatrix4fv(this.addr,!1,Gm),Mn(t,i)}}function cw(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function uw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2iv(this.addr,e),Mn(t,e)}}function hw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;n.uniform3iv(this.addr,e),Mn(t,e)}}function fw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4iv(this.addr,e),Mn(t,e)}}function dw(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function pw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2uiv(this.addr,e),Mn(t,e)}}function mw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;n.uniform3uiv(this.addr,e),Mn(t,e)}}function gw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4uiv(this.addr,e),Mn(t,e)}}function mu(n){return n.version===0&&(n.compareFunction=hf,n.needsUpdate=!0),n}function _w(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=mu(lg):r=ag,t.setTexture2D(e||r,s)}function xw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||hg,s)}function vw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=mu(cg):r=fg,t.setTextureCube(e||r,s)}function yw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||ug,s)}function Sw(n){switch(n){case 5126:return nw;case 35664:return iw;case 35665:return sw;case 35666:return rw;case 35674:return ow;case 35675:return aw;case 35676:return lw;case 5124:case 35670:return cw;case 35667:case 35671:return uw;case 35668:case 35672:return hw;case 35669:case 35673:return fw;case 5125:return dw;case 36294:return pw;case 36295:return mw;case 36296:return gw;case 35678:case 36198:case 36298:case 36306:case 35682:return _w;case 35679:case 36299:case 36307:return xw;case 35680:case 36300:case 36308:case 36293:return vw;case 36289:case 36303:case 36311:case 36292:return yw}}function Mw(n,e){n.uniform1fv(this.addr,e)}function bw(n,e){let t=bo(e,this.size,2);n.uniform2fv(this.addr,t)}function ww(n,e){let t=bo(e,this.size,3);n.uniform3fv(this.addr,t)}function Tw(n,e){let t=bo(e,this.size,4);n.uniform4fv(this.addr,t)}function Aw(n,e){let t=bo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function Ew(n,e){let t=bo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function Cw(n,e){let t=bo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function Rw(n,e){n.uniform1iv(this.addr,e)}function Pw(n,e){n.uniform2iv(this.addr,e)}function Iw(n,e){n.uniform3iv(this.addr,e)}function Lw(n,e){n.uniform4iv(this.addr,e)}function Nw(n,e){n.uniform1uiv(this.addr,e)}function Dw(n,e){n.uniform2uiv(this.addr,e)}function Uw(n,e){n.uniform3uiv(this.addr,e)}function Fw(n,e){n.uniform4uiv(this.addr,e)}function Ow(n,e,t){let i=this.cache,s=e.length,r=pu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=mu(lg):o=ag;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function Bw(n,e,t){let i=this.cache,s=e.length,r=pu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||hg,r[o])}function kw(n,e,t){let i=this.cache,s=e.length,r=pu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=mu(cg):o=fg;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function zw(n,e,t){let i=this.cache,s=e.length,r=pu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||ug,r[o])}function Vw(n){switch(n){case 5126:return Mw;case 35664:return bw;case 35665:return ww;case 35666:return Tw;case 35674:return Aw;case 35675:return Ew;case 35676:return Cw;case 5124:case 35670:return Rw;case 35667:case 35671:return Pw;case 35668:case 35672:return Iw;case 35669:case 35673:return Lw;case 5125:return Nw;case 36294:return Dw;case 36295:return Uw;case 36296:return Fw;case 35678:case 36198:case 36298:case 36306:case 35682:return Ow;case 35679:case 36299:case 36307:return Bw;case 35680:case 36300:case 36308:case 36293:return kw;case 36289:case 36303:case 36311:case 36292:return zw}}var Sf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=Sw(t.type)}},Mf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Vw(t.type)}},bf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},vf=/(\w+)(\])?(\[|\.)?/g;function Xm(n,e){n.seq.push(e),n.map[e.id]=e}function Gw(n,e,t){let i=n.name,s=i.length;for(vf.lastIndex=0;;){let r=vf.exec(i),o=vf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Xm(t,c===void 0?new Sf(a,n,e):new Mf(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new bf(a),Xm(t,h)),t=h}}}var Mo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);Gw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function qm(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var Hw=37297,Ww=0;function Xw(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var $m=new et;function qw(n){gt._getMatrix($m,gt.workingColorSpace,n);let e=`mat3( ${$m.elements.map(t=>t.toFixed(4))} )`;switch(gt.getTransfer(n)){case la:return[e,"LinearTransferOETF"];case Tt:return[e,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Ym(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+Xw(n.getShaderSource(e),a)}else return r}function $w(n,e){let t=qw(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Yw={[Zh]:"Linear",[Jh]:"Reinhard",[Kh]:"Cineon",[jh]:"ACESFilmic",[ef]:"AgX",[Pa]:"Neutral",[Qh]:"Custom"};function Zw(n,e){let t=Yw[e];return t===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var hu=new W;function Jw(){gt.getLuminanceCoefficients(hu);let n=hu.x.toFixed(4),e=hu.y.toFixed(4),t=hu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Kw(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Va).join(`
`)}function jw(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function Qw(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Va(n){return n!==""}function Zm(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Jm(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var e1=/^[ \t]*#include +<([\w\d./]+)>/gm;function wf(n){return n.replace(e1,t1)}function t1(n,e){let t=lt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return wf(t)}var n1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Km(n){return n.replace(n1,i1)}function i1(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function jm(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var s1={[hr]:"SHADOWMAP_TYPE_PCF",[_o]:"SHADOWMAP_TYPE_VSM"};function r1(n){return s1[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var o1={[vo]:"ENVMAP_MODE_REFRACTION"};function a1(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":o1[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var l1={[wc]:"ENVMAP_BLENDING_MULTIPLY",[mm]:"ENVMAP_BLENDING_MIX",[gm]:"ENVMAP_BLENDING_ADD"};function c1(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":l1[n.combine]||"ENVMAP_BLENDING_NONE"}function u1(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=r1(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=a1(t),h=c1(t),f=Kw(t),p=jw(r),g=s.createProgram(),v,d,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Va).join(`
`),v.length>0&&(v+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Va).join(`
`),d.length>0&&(d+=`
`)):(v=[jm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Va).join(`
`),d=[jm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ts?"#define TONE_MAPPING":"",t.toneMapping!==ts?lt.tonemapping_pars_fragment:"",t.toneMapping!==ts?Zw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",lt.colorspace_pars_fragment,$w("linearToOutputTexel",t.outputColorSpace),Jw(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Va).join(`
`)),o=wf(o),o=Zm(o,t),o=Jm(o,t),a=wf(a),a=Zm(a,t),a=Jm(a,t),o=Km(o),a=Km(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,v=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,d=["#define varying in",t.glslVersion===ff?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===ff?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let y=m+v+o,C=m+d+a,b=qm(s,s.VERTEX_SHADER,y),P=qm(s,s.FRAGMENT_SHADER,C);s.attachShader(g,b),s.attachShader(g,P),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function A(D){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(g)||"",k=s.getShaderInfoLog(b)||"",V=s.getShaderInfoLog(P)||"",N=I.trim(),H=k.trim(),$=V.trim(),G=!0,le=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,b,P);else{let J=Ym(s,b,"vertex"),j=Ym(s,P,"fragment");je("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+N+`
`+J+`
`+j)}else N!==""?Ye("WebGLProgram: Program Info Log:",N):(H===""||$==="")&&(le=!1);le&&(D.diagnostics={runnable:G,programLog:N,vertexShader:{log:H,prefix:v},fragmentShader:{log:$,prefix:d}})}s.deleteShader(b),s.deleteShader(P),x=new Mo(s,g),T=Qw(s,g)}let x;this.getUniforms=function(){return x===void 0&&A(this),x};let T;this.getAttributes=function(){return T===void 0&&A(this),T};let B=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=s.getProgramParameter(g,Hw)),B},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Ww++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=b,this.fragmentShader=P,this}var h1=0,Tf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Af(e),t.set(e,i)),i}},Af=class{constructor(e){this.id=h1++,this.code=e,this.usedTimes=0}};function f1(n){return n===Bi||n===Fa||n===Oa}function d1(n,e,t,i,s,r){let o=new lo,a=new Tf,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,T,B,D,I,k){let V=D.fog,N=I.geometry,H=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?D.environment:null,$=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,G=e.get(x.envMap||H,$),le=f[x.type],J=i.precision;x.precision!==null&&(J=i.getMaxPrecision(x.precision),J!==x.precision&&Ye("WebGLProgram.getParameters:",x.precision,"not supported, using",J,"instead."));let j=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ie=j!==void 0?j.length:0,fe=0;N.morphAttributes.position!==void 0&&(fe=1),N.morphAttributes.normal!==void 0&&(fe=2),N.morphAttributes.color!==void 0&&(fe=3);let ue,Q,me,xe;if(le){let Ce=is[le];ue=Ce.vertexShader,Q=Ce.fragmentShader}else{ue=x.vertexShader,Q=x.fragmentShader;let Ce=a.getVertexShaderStage(x),rt=a.getFragmentShaderStage(x);a.update(x,Ce,rt),me=Ce.id,xe=rt.id}let Ee=n.getRenderTarget(),Me=n.state.buffers.depth.getReversed(),He=I.isInstancedMesh===!0,it=I.isBatchedMesh===!0,Ve=!!x.map,ct=!!x.matcap,ot=!!G,tt=ot&&G.isPMREMTexture===!0,$t=!!x.aoMap,Ot=!!x.lightMap,cn=!!x.bumpMap&&x.wireframe===!1,It=!!x.normalMap,Tn=!!x.displacementMap,vt=!!x.emissiveMap,vn=!!x.metalnessMap,jt=!!x.roughnessMap,un=x.anisotropy>0,F=x.clearcoat>0,Re=x.diffuseRoughness>0,$e=x.dispersion>0,st=x.retroreflectivity>0,be=x.iridescence>0,Dt=x.sheen>0,ze=x.transmission>0,qe=un&&!!x.anisotropyMap,E=F&&!!x.clearcoatMap,S=F&&!!x.clearcoatNormalMap,X=F&&!!x.clearcoatRoughnessMap,ce=Re&&!!x.diffuseRoughnessMap,re=be&&!!x.iridescenceMap,_e=be&&!!x.iridescenceThicknessMap,ve=Dt&&!!x.sheenColorMap,ee=Dt&&!!x.sheenRoughnessMap,ne=!!x.specularMap,pe=!!x.specularColorMap,U=!!x.specularIntensityMap,se=ze&&!!x.transmissionMap,te=ze&&!!x.thicknessMap,we=!!x.gradientMap,ge=!!x.alphaMap,Se=x.alphaTest>0,Ge=!!x.alphaHash,Je=!!x.extensions,ae=ts;x.toneMapped&&(Ee===null||Ee.isXRRenderTarget===!0)&&(ae=n.toneMapping);let Oe=tt?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Ke={shaderID:le,shaderType:x.type,shaderName:x.name,vertexShader:ue,fragmentShader:Q,defines:x.defines,customVertexShaderID:me,customFragmentShaderID:xe,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:J,batching:it,batchingColor:it&&I._colorsTexture!==null,instancing:He,instancingColor:He&&I.instanceColor!==null,instancingMorph:He&&I.morphTexture!==null,outputColorSpace:Ee===null?n.outputColorSpace:Ee.isXRRenderTarget===!0?Ee.texture.colorSpace:gt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Ve,matcap:ct,envMap:ot,envMapMode:ot&&G.mapping,envMapPMREM:tt,envMapMaxLod:tt?Oe.length-1:null,envMapSize:tt?Oe[0].width:null,aoMap:$t,lightMap:Ot,bumpMap:cn,normalMap:It,displacementMap:Tn,emissiveMap:vt,normalMapObjectSpace:It&&x.normalMapType===vm,normalMapTangentSpace:It&&x.normalMapType===Ba,packedNormalMap:It&&x.normalMapType===Ba&&f1(x.normalMap.format),metalnessMap:vn,roughnessMap:jt,anisotropy:un,anisotropyMap:qe,clearcoat:F,clearcoatMap:E,clearcoatNormalMap:S,clearcoatRoughnessMap:X,diffuseRoughness:Re,diffuseRoughnessMap:ce,dispersion:$e,retroreflection:st,iridescence:be,iridescenceMap:re,iridescenceThicknessMap:_e,sheen:Dt,sheenColorMap:ve,sheenRoughnessMap:ee,specularMap:ne,specularColorMap:pe,specularIntensityMap:U,transmission:ze,transmissionMap:se,thicknessMap:te,gradientMap:we,opaque:x.transparent===!1&&x.blending===xo&&x.alphaToCoverage===!1,alphaMap:ge,alphaTest:Se,alphaHash:Ge,combine:x.combine,mapUv:Ve&&p(x.map.channel),aoMapUv:$t&&p(x.aoMap.channel),lightMapUv:Ot&&p(x.lightMap.channel),bumpMapUv:cn&&p(x.bumpMap.channel),normalMapUv:It&&p(x.normalMap.channel),displacementMapUv:Tn&&p(x.displacementMap.channel),emissiveMapUv:vt&&p(x.emissiveMap.channel),metalnessMapUv:vn&&p(x.metalnessMap.channel),roughnessMapUv:jt&&p(x.roughnessMap.channel),anisotropyMapUv:qe&&p(x.anisotropyMap.channel),clearcoatMapUv:E&&p(x.clearcoatMap.channel),clearcoatNormalMapUv:S&&p(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&p(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ce&&p(x.diffuseRoughnessMap.channel),iridescenceMapUv:re&&p(x.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&p(x.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&p(x.sheenColorMap.channel),sheenRoughnessMapUv:ee&&p(x.sheenRoughnessMap.channel),specularMapUv:ne&&p(x.specularMap.channel),specularColorMapUv:pe&&p(x.specularColorMap.channel),specularIntensityMapUv:U&&p(x.specularIntensityMap.channel),transmissionMapUv:se&&p(x.transmissionMap.channel),thicknessMapUv:te&&p(x.thicknessMap.channel),alphaMapUv:ge&&p(x.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(It||un),vertexNormals:!!N.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!N.attributes.uv&&(Ve||ge),fog:!!V,useFog:x.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||N.attributes.normal===void 0&&It===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Me,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:fe,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:k.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&B.length>0,shadowMapType:n.shadowMap.type,toneMapping:ae,decodeVideoTexture:Ve&&x.map.isVideoTexture===!0&&gt.getTransfer(x.map.colorSpace)===Tt,decodeVideoTextureEmissive:vt&&x.emissiveMap.isVideoTexture===!0&&gt.getTransfer(x.emissiveMap.colorSpace)===Tt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===es,flipSided:x.side===Kn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Je&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&x.extensions.multiDraw===!0||it)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Ke.vertexUv1s=l.has(1),Ke.vertexUv2s=l.has(2),Ke.vertexUv3s=l.has(3),l.clear(),Ke}function v(x){let T=[];if(x.shaderID?T.push(x.shaderID):(T.push(x.customVertexShaderID),T.push(x.customFragmentShaderID)),x.defines!==void 0)for(let B in x.defines)T.push(B),T.push(x.defines[B]);return x.isRawShaderMaterial===!1&&(d(T,x),m(T,x),T.push(n.outputColorSpace)),T.push(x.customProgramCacheKey),T.join()}function d(x,T){x.push(T.precision),x.push(T.outputColorSpace),x.push(T.envMapMode),x.push(T.envMapPMREM),x.push(T.envMapMaxLod),x.push(T.envMapSize),x.push(T.mapUv),x.push(T.alphaMapUv),x.push(T.lightMapUv),x.push(T.aoMapUv),x.push(T.bumpMapUv),x.push(T.normalMapUv),x.push(T.displacementMapUv),x.push(T.emissiveMapUv),x.push(T.metalnessMapUv),x.push(T.roughnessMapUv),x.push(T.anisotropyMapUv),x.push(T.clearcoatMapUv),x.push(T.clearcoatNormalMapUv),x.push(T.clearcoatRoughnessMapUv),x.push(T.diffuseRoughnessMapUv),x.push(T.iridescenceMapUv),x.push(T.iridescenceThicknessMapUv),x.push(T.sheenColorMapUv),x.push(T.sheenRoughnessMapUv),x.push(T.specularMapUv),x.push(T.specularColorMapUv),x.push(T.specularIntensityMapUv),x.push(T.transmissionMapUv),x.push(T.thicknessMapUv),x.push(T.combine),x.push(T.fogExp2),x.push(T.sizeAttenuation),x.push(T.morphTargetsCount),x.push(T.numSunLights),x.push(T.numDirLights),x.push(T.numPointLights),x.push(T.numSpotLights),x.push(T.numSpotLightMaps),x.push(T.numHemiLights),x.push(T.numRectAreaLights),x.push(T.numSunLightShadows),x.push(T.numDirLightShadows),x.push(T.numPointLightShadows),x.push(T.numSpotLightShadows),x.push(T.numSpotLightShadowsWithMaps),x.push(T.numLightProbes),x.push(T.numLightProbeGrids),x.push(T.shadowMapType),x.push(T.toneMapping),x.push(T.numClippingPlanes),x.push(T.numClipIntersection),x.push(T.depthPacking)}function m(x,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function y(x){let T=f[x.type],B;if(T){let D=is[T];B=Nm.clone(D.uniforms)}else B=x.uniforms;return B}function C(x,T){let B=u.get(T);return B!==void 0?++B.usedTimes:(B=new u1(n,T,x,s),c.push(B),u.set(T,B)),B}function b(x){if(--x.usedTimes===0){let T=c.indexOf(x);c[T]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function P(x){a.remove(x)}function A(){a.dispose()}return{getParameters:g,getProgramCacheKey:v,getUniforms:y,acquireProgram:C,releaseProgram:b,releaseShaderCache:P,programs:c,dispose:A}}function p1(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function m1(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Qm(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function eg(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(f){let p=0;return f.isInstancedMesh&&(p+=2),f.isSkinnedMesh&&(p+=1),p}function a(f,p,g,v,d,m){let y=n[e];return y===void 0?(y={id:f.id,object:f,geometry:p,material:g,materialVariant:o(f),groupOrder:v,renderOrder:f.renderOrder,z:d,group:m},n[e]=y):(y.id=f.id,y.object=f,y.geometry=p,y.material=g,y.materialVariant=o(f),y.groupOrder=v,y.renderOrder=f.renderOrder,y.z=d,y.group=m),e++,y}function l(f,p,g,v,d,m,y){y.reversedDepth===!0&&(d=-d);let C=a(f,p,g,v,d,m);g.transmission>0?i.push(C):g.transparent===!0?s.push(C):t.push(C)}function c(f,p,g,v,d,m){let y=a(f,p,g,v,d,m);g.transmission>0?i.unshift(y):g.transparent===!0?s.unshift(y):t.unshift(y)}function u(f,p){t.length>1&&t.sort(f||m1),i.length>1&&i.sort(p||Qm),s.length>1&&s.sort(p||Qm)}function h(){for(let f=e,p=n.length;f<p;f++){let g=n[f];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function g1(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new eg,n.set(i,[o])):s>=r.length?(o=new eg,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function _1(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new W,color:new Xe};break;case"SpotLight":t={position:new W,direction:new W,color:new Xe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new W,color:new Xe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new W,skyColor:new Xe,groundColor:new Xe};break;case"RectAreaLight":t={color:new Xe,position:new W,halfWidth:new W,halfHeight:new W};break}return n[e.id]=t,t}}}function x1(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ut};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ut};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ut,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var v1=0;function y1(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function S1(n){let e=new _1,t=x1(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new W);let s=new W,r=new yt,o=new yt;function a(c){let u=0,h=0,f=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let p=0,g=0,v=0,d=0,m=0,y=0,C=0,b=0,P=0,A=0,x=0,T=0,B=0,D=0;c.sort(y1);for(let k=0,V=c.length;k<V;k++){let N=c[k],H=N.color,$=N.intensity,G=N.distance,le=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Bi?le=N.shadow.map.texture:le=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=H.r*$,h+=H.g*$,f+=H.b*$;else if(N.isLightProbe){for(let J=0;J<9;J++)i.probe[J].addScaledVector(N.sh.coefficients[J],$);D++}else if(N.isSunLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let j=N.shadow,ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[g]=ie,i.sunShadowMap[g]=le;let fe=j.getViewportCount();for(let ue=0;ue<fe;ue++)i.sunShadowMatrix[v+ue]=j.getMatrix(ue),i.sunShadowCascade[v+ue]=j._cascadeData[ue];v+=fe,g++}i.sun[p]=J,p++}else if(N.isDirectionalLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let j=N.shadow,ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,i.directionalShadow[d]=ie,i.directionalShadowMap[d]=le,i.directionalShadowMatrix[d]=N.shadow.matrix,P++}i.directional[d]=J,d++}else if(N.isSpotLight){let J=e.get(N);J.position.setFromMatrixPosition(N.matrixWorld),J.color.copy(H).multiplyScalar($),J.distance=G,J.coneCos=Math.cos(N.angle),J.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),J.decay=N.decay,i.spot[y]=J;let j=N.shadow;if(N.map&&(i.spotLightMap[T]=N.map,T++,j.updateMatrices(N),N.castShadow&&B++),i.spotLightMatrix[y]=j.matrix,N.castShadow){let ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,i.spotShadow[y]=ie,i.spotShadowMap[y]=le,x++}y++}else if(N.isRectAreaLight){let J=e.get(N);J.color.copy(H).multiplyScalar($),J.halfWidth.set(N.width*.5,0,0),J.halfHeight.set(0,N.height*.5,0),i.rectArea[C]=J,C++}else if(N.isPointLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),J.distance=N.distance,J.decay=N.decay,N.castShadow){let j=N.shadow,ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,ie.shadowCameraNear=j.camera.near,ie.shadowCameraFar=j.camera.far,i.pointShadow[m]=ie,i.pointShadowMap[m]=le,i.pointShadowMatrix[m]=N.shadow.matrix,A++}i.point[m]=J,m++}else if(N.isHemisphereLight){let J=e.get(N);J.skyColor.copy(N.color).multiplyScalar($),J.groundColor.copy(N.groundColor).multiplyScalar($),i.hemi[b]=J,b++}}C>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let I=i.hash;(I.sunLength!==p||I.directionalLength!==d||I.pointLength!==m||I.spotLength!==y||I.rectAreaLength!==C||I.hemiLength!==b||I.numSunShadows!==g||I.numDirectionalShadows!==P||I.numPointShadows!==A||I.numSpotShadows!==x||I.numSpotMaps!==T||I.numLightProbes!==D)&&(i.sun.length=p,i.directional.length=d,i.spot.length=y,i.rectArea.length=C,i.point.length=m,i.hemi.length=b,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=v,i.sunShadowCascade.length=v,i.directionalShadow.length=P,i.directionalShadowMap.length=P,i.directionalShadowMatrix.length=P,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+T-B,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=B,i.numLightProbes=D,I.sunLength=p,I.directionalLength=d,I.pointLength=m,I.spotLength=y,I.rectAreaLength=C,I.hemiLength=b,I.numSunShadows=g,I.numDirectionalShadows=P,I.numPointShadows=A,I.numSpotShadows=x,I.numSpotMaps=T,I.numLightProbes=D,i.version=v1++)}function l(c,u){let h=0,f=0,p=0,g=0,v=0,d=0,m=u.matrixWorldInverse;for(let y=0,C=c.length;y<C;y++){let b=c[y];if(b.isSunLight){let P=i.sun[h];P.direction.setFromMatrixPosition(b.matrixWorld),P.direction.transformDirection(m),h++}else if(b.isDirectionalLight){let P=i.directional[f];P.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),f++}else if(b.isSpotLight){let P=i.spot[g];P.position.setFromMatrixPosition(b.matrixWorld),P.position.applyMatrix4(m),P.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),g++}else if(b.isRectAreaLight){let P=i.rectArea[v];P.position.setFromMatrixPosition(b.matrixWorld),P.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),P.halfWidth.set(b.width*.5,0,0),P.halfHeight.set(0,b.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),v++}else if(b.isPointLight){let P=i.point[p];P.position.setFromMatrixPosition(b.matrixWorld),P.position.applyMatrix4(m),p++}else if(b.isHemisphereLight){let P=i.hemi[d];P.direction.setFromMatrixPosition(b.matrixWorld),P.direction.transformDirection(m),d++}}}return{setup:a,setupView:l,state:i}}function tg(n){let e=new S1(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function M1(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new tg(n),e.set(s,[a])):r>=o.length?(a=new tg(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var b1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,w1=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,T1=[new W(1,0,0),new W(-1,0,0),new W(0,1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1)],A1=[new W(0,-1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1),new W(0,-1,0),new W(0,-1,0)],ng=new yt,za=new W,yf=new W;function E1(n,e,t){let i=new Gs,s=new ut,r=new ut,o=new Bt,a=new uc,l=new hc,c={},u=t.maxTextureSize,h={[$s]:Kn,[Kn]:$s,[es]:es},f=new ti({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ut},radius:{value:4}},vertexShader:b1,fragmentShader:w1}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let g=new Un;g.setAttribute("position",new ln(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new kt(g,f),d=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=hr;let m=this.type;this.render=function(A,x,T){if(d.enabled===!1||d.autoUpdate===!1&&d.needsUpdate===!1||A.length===0)return;this.type===Jp&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=hr);let B=n.getRenderTarget(),D=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),k=n.state;k.setBlending(fr),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let V=m!==this.type;V&&x.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(H=>H.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,H=A.length;N<H;N++){let $=A[N],G=$.shadow;if(G===void 0){Ye("WebGLShadowMap:",$,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let le=G.getFrameExtents();s.multiply(le),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,G.mapSize.y=r.y));let J=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=J,G.map===null||V===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===_o){if($.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new ui(s.x,s.y,{format:Bi,type:Oi,minFilter:Jn,magFilter:Jn,generateMipmaps:!1}),G.map.texture.name=$.name+".shadowMap",G.map.depthTexture=new vs(s.x,s.y,Si),G.map.depthTexture.name=$.name+".shadowMapDepth",G.map.depthTexture.format=_s,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=In,G.map.depthTexture.magFilter=In}else $.isPointLight?(G.map=new Ga(s.x),G.map.depthTexture=new xa(s.x,Fi)):(G.map=new ui(s.x,s.y),G.map.depthTexture=new vs(s.x,s.y,Fi)),G.map.depthTexture.name=$.name+".shadowMap",G.map.depthTexture.format=_s,this.type===hr?(G.map.depthTexture.compareFunction=J?uf:cf,G.map.depthTexture.minFilter=Jn,G.map.depthTexture.magFilter=Jn):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=In,G.map.depthTexture.magFilter=In);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let j=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();$.isPointLight!==!0&&G.updateMatrices($,T);let ie=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:T.layers;for(let fe=0;fe<j;fe++){let ue=G.getCamera(fe);if($.isPointLight){let Q=G.camera,me=G.matrix,xe=$.distance||Q.far;xe!==Q.far&&(Q.far=xe,Q.updateProjectionMatrix()),za.setFromMatrixPosition($.matrixWorld),Q.position.copy(za),yf.copy(Q.position),yf.add(T1[fe]),Q.up.copy(A1[fe]),Q.lookAt(yf),Q.updateMatrixWorld(),me.makeTranslation(-za.x,-za.y,-za.z),ng.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),G._frustum.setFromProjectionMatrix(ng,Q.coordinateSystem,Q.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,fe),n.clear();else{fe===0&&(n.setRenderTarget(G.map),n.clear());let Q=G.getViewport(fe);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),k.viewport(o)}i=G.getFrustum(fe),b(x,T,ue,$,ie,this.type)}G.isPointLightShadow!==!0&&this.type===_o&&y(G,T),G.needsUpdate=!1}m=this.type,d.needsUpdate=!1,n.setRenderTarget(B,D,I)};function y(A,x){let T=e.update(v);f.defines.VSM_SAMPLES!==A.blurSamples&&(f.defines.VSM_SAMPLES=A.blurSamples,p.defines.VSM_SAMPLES=A.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),A.mapPass===null?A.mapPass=new ui(s.x,s.y,{format:Bi,type:Oi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),f.uniforms.shadow_pass.value=A.map.depthTexture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(x,null,T,f,v,null),p.uniforms.shadow_pass.value=A.mapPass.texture,p.uniforms.resolution.value.set(A.map.width,A.map.height),p.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(x,null,T,p,v,null)}function C(A,x,T,B){let D=null,I=T.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(I!==void 0)D=I;else if(D=T.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let k=D.uuid,V=x.uuid,N=c[k];N===void 0&&(N={},c[k]=N);let H=N[V];H===void 0&&(H=D.clone(),N[V]=H,x.addEventListener("dispose",P)),D=H}if(D.visible=x.visible,D.wireframe=x.wireframe,B===_o?D.side=x.shadowSide!==null?x.shadowSide:x.side:D.side=x.shadowSide!==null?x.shadowSide:h[x.side],D.alphaMap=x.alphaMap,D.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,D.map=x.map,D.clipShadows=x.clipShadows,D.clippingPlanes=x.clippingPlanes,D.clipIntersection=x.clipIntersection,D.displacementMap=x.displacementMap,D.displacementScale=x.displacementScale,D.displacementBias=x.displacementBias,D.wireframeLinewidth=x.wireframeLinewidth,D.linewidth=x.linewidth,T.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let k=n.properties.get(D);k.light=T}return D}function b(A,x,T,B,D,I){if(A.visible===!1)return;if(A.layers.test(D)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&I===_o)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,A.matrixWorld);let N=e.update(A),H=A.material;if(Array.isArray(H)){let $=N.groups;for(let G=0,le=$.length;G<le;G++){let J=$[G],j=H[J.materialIndex];if(j&&j.visible){let ie=C(A,j,B,I);A.onBeforeShadow(n,A,x,T,N,ie,J),n.renderBufferDirect(T,null,N,ie,A,J),A.onAfterShadow(n,A,x,T,N,ie,J)}}}else if(H.visible){let $=C(A,H,B,I);A.onBeforeShadow(n,A,x,T,N,$,null),n.renderBufferDirect(T,null,N,$,A,null),A.onAfterShadow(n,A,x,T,N,$,null)}}let V=A.children;for(let N=0,H=V.length;N<H;N++)b(V[N],x,T,B,D,I)}function P(A){A.target.removeEventListener("dispose",P);for(let T in c){let B=c[T],D=A.target.uuid;D in B&&(B[D].dispose(),delete B[D])}}}function C1(n,e){function t(){let U=!1,se=new Bt,te=null,we=new Bt(0,0,0,0);return{setMask:function(ge){te!==ge&&!U&&(n.colorMask(ge,ge,ge,ge),te=ge)},setLocked:function(ge){U=ge},setClear:function(ge,Se,Ge,Je,ae){ae===!0&&(ge*=Je,Se*=Je,Ge*=Je),se.set(ge,Se,Ge,Je),we.equals(se)===!1&&(n.clearColor(ge,Se,Ge,Je),we.copy(se))},reset:function(){U=!1,te=null,we.set(-1,0,0,0)}}}function i(){let U=!1,se=!1,te=null,we=null,ge=null;return{setReversed:function(Se){if(se!==Se){let Ge=e.get("EXT_clip_control");Se?Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.ZERO_TO_ONE_EXT):Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.NEGATIVE_ONE_TO_ONE_EXT),se=Se;let Je=ge;ge=null,this.setClear(Je)}},getReversed:function(){return se},setTest:function(Se){Se?Me(n.DEPTH_TEST):He(n.DEPTH_TEST)},setMask:function(Se){te!==Se&&!U&&(n.depthMask(Se),te=Se)},setFunc:function(Se){if(se&&(Se=Pm[Se]),we!==Se){switch(Se){case Xl:n.depthFunc(n.NEVER);break;case ql:n.depthFunc(n.ALWAYS);break;case $l:n.depthFunc(n.LESS);break;case so:n.depthFunc(n.LEQUAL);break;case Yl:n.depthFunc(n.EQUAL);break;case Zl:n.depthFunc(n.GEQUAL);break;case Jl:n.depthFunc(n.GREATER);break;case Kl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}we=Se}},setLocked:function(Se){U=Se},setClear:function(Se){ge!==Se&&(ge=Se,se&&(Se=1-Se),n.clearDepth(Se))},reset:function(){U=!1,te=null,we=null,ge=null,se=!1}}}function s(){let U=!1,se=null,te=null,we=null,ge=null,Se=null,Ge=null,Je=null,ae=null;return{setTest:function(Oe){U||(Oe?Me(n.STENCIL_TEST):He(n.STENCIL_TEST))},setMask:function(Oe){se!==Oe&&!U&&(n.stencilMask(Oe),se=Oe)},setFunc:function(Oe,Ke,Ce){(te!==Oe||we!==Ke||ge!==Ce)&&(n.stencilFunc(Oe,Ke,Ce),te=Oe,we=Ke,ge=Ce)},setOp:function(Oe,Ke,Ce){(Se!==Oe||Ge!==Ke||Je!==Ce)&&(n.stencilOp(Oe,Ke,Ce),Se=Oe,Ge=Ke,Je=Ce)},setLocked:function(Oe){U=Oe},setClear:function(Oe){ae!==Oe&&(n.clearStencil(Oe),ae=Oe)},reset:function(){U=!1,se=null,te=null,we=null,ge=null,Se=null,Ge=null,Je=null,ae=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},f={},p=new WeakMap,g=[],v=null,d=!1,m=null,y=null,C=null,b=null,P=null,A=null,x=null,T=new Xe(0,0,0),B=0,D=!1,I=null,k=null,V=null,N=null,H=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,le=0,J=n.getParameter(n.VERSION);J.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(J)[1]),G=le>=1):J.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),G=le>=2);let j=null,ie={},fe=n.getParameter(n.SCISSOR_BOX),ue=n.getParameter(n.VIEWPORT),Q=new Bt().fromArray(fe),me=new Bt().fromArray(ue);function xe(U,se,te,we){let ge=new Uint8Array(4),Se=n.createTexture();n.bindTexture(U,Se),n.texParameteri(U,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(U,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ge=0;Ge<te;Ge++)U===n.TEXTURE_3D||U===n.TEXTURE_2D_ARRAY?n.texImage3D(se,0,n.RGBA,1,1,we,0,n.RGBA,n.UNSIGNED_BYTE,ge):n.texImage2D(se+Ge,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ge);return Se}let Ee={};Ee[n.TEXTURE_2D]=xe(n.TEXTURE_2D,n.TEXTURE_2D,1),Ee[n.TEXTURE_CUBE_MAP]=xe(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ee[n.TEXTURE_2D_ARRAY]=xe(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ee[n.TEXTURE_3D]=xe(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Me(n.DEPTH_TEST),o.setFunc(so),cn(!1),It(Hh),Me(n.CULL_FACE),$t(fr);function Me(U){u[U]!==!0&&(n.enable(U),u[U]=!0)}function He(U){u[U]!==!1&&(n.disable(U),u[U]=!1)}function it(U,se){return f[U]!==se?(n.bindFramebuffer(U,se),f[U]=se,U===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=se),U===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=se),!0):!1}function Ve(U,se){let te=g,we=!1;if(U){te=p.get(se),te===void 0&&(te=[],p.set(se,te));let ge=U.textures;if(te.length!==ge.length||te[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,Ge=ge.length;Se<Ge;Se++)te[Se]=n.COLOR_ATTACHMENT0+Se;te.length=ge.length,we=!0}}else te[0]!==n.BACK&&(te[0]=n.BACK,we=!0);we&&n.drawBuffers(te)}function ct(U){return v!==U?(n.useProgram(U),v=U,!0):!1}let ot={[dr]:n.FUNC_ADD,[jp]:n.FUNC_SUBTRACT,[Qp]:n.FUNC_REVERSE_SUBTRACT};ot[em]=n.MIN,ot[tm]=n.MAX;let tt={[nm]:n.ZERO,[im]:n.ONE,[sm]:n.SRC_COLOR,[$h]:n.SRC_ALPHA,[um]:n.SRC_ALPHA_SATURATE,[lm]:n.DST_COLOR,[om]:n.DST_ALPHA,[rm]:n.ONE_MINUS_SRC_COLOR,[Yh]:n.ONE_MINUS_SRC_ALPHA,[cm]:n.ONE_MINUS_DST_COLOR,[am]:n.ONE_MINUS_DST_ALPHA,[hm]:n.CONSTANT_COLOR,[fm]:n.ONE_MINUS_CONSTANT_COLOR,[dm]:n.CONSTANT_ALPHA,[pm]:n.ONE_MINUS_CONSTANT_ALPHA};function $t(U,se,te,we,ge,Se,Ge,Je,ae,Oe){if(U===fr){d===!0&&(He(n.BLEND),d=!1);return}if(d===!1&&(Me(n.BLEND),d=!0),U!==Kp){if(U!==m||Oe!==D){if((y!==dr||P!==dr)&&(n.blendEquation(n.FUNC_ADD),y=dr,P=dr),Oe)switch(U){case xo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Wh:n.blendFunc(n.ONE,n.ONE);break;case Xh:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case qh:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:je("WebGLState: Invalid blending: ",U);break}else switch(U){case xo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Wh:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Xh:je("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case qh:je("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:je("WebGLState: Invalid blending: ",U);break}C=null,b=null,A=null,x=null,T.set(0,0,0),B=0,m=U,D=Oe}return}ge=ge||se,Se=Se||te,Ge=Ge||we,(se!==y||ge!==P)&&(n.blendEquationSeparate(ot[se],ot[ge]),y=se,P=ge),(te!==C||we!==b||Se!==A||Ge!==x)&&(n.blendFuncSeparate(tt[te],tt[we],tt[Se],tt[Ge]),C=te,b=we,A=Se,x=Ge),(Je.equals(T)===!1||ae!==B)&&(n.blendColor(Je.r,Je.g,Je.b,ae),T.copy(Je),B=ae),m=U,D=!1}function Ot(U,se){U.side===es?He(n.CULL_FACE):Me(n.CULL_FACE);let te=U.side===Kn;se&&(te=!te),cn(te),U.blending===xo&&U.transparent===!1?$t(fr):$t(U.blending,U.blendEquation,U.blendSrc,U.blendDst,U.blendEquationAlpha,U.blendSrcAlpha,U.blendDstAlpha,U.blendColor,U.blendAlpha,U.premultipliedAlpha),o.setFunc(U.depthFunc),o.setTest(U.depthTest),o.setMask(U.depthWrite),r.setMask(U.colorWrite);let we=U.stencilWrite;a.setTest(we),we&&(a.setMask(U.stencilWriteMask),a.setFunc(U.stencilFunc,U.stencilRef,U.stencilFuncMask),a.setOp(U.stencilFail,U.stencilZFail,U.stencilZPass)),vt(U.polygonOffset,U.polygonOffsetFactor,U.polygonOffsetUnits),U.alphaToCoverage===!0?Me(n.SAMPLE_ALPHA_TO_COVERAGE):He(n.SAMPLE_ALPHA_TO_COVERAGE)}function cn(U){I!==U&&(U?n.frontFace(n.CW):n.frontFace(n.CCW),I=U)}function It(U){U!==Yp?(Me(n.CULL_FACE),U!==k&&(U===Hh?n.cullFace(n.BACK):U===Zp?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):He(n.CULL_FACE),k=U}function Tn(U){U!==V&&(G&&n.lineWidth(U),V=U)}function vt(U,se,te){U?(Me(n.POLYGON_OFFSET_FILL),(N!==se||H!==te)&&(N=se,H=te,o.getReversed()&&(se=-se,te=-te),n.polygonOffset(se,te))):He(n.POLYGON_OFFSET_FILL)}function vn(U){U?Me(n.SCISSOR_TEST):He(n.SCISSOR_TEST)}function jt(U){U===void 0&&(U=n.TEXTURE0+$-1),j!==U&&(n.activeTexture(U),j=U)}function un(U,se,te){te===void 0&&(j===null?te=n.TEXTURE0+$-1:te=j);let we=ie[te];we===void 0&&(we={type:void 0,texture:void 0},ie[te]=we),(we.type!==U||we.texture!==se)&&(j!==te&&(n.activeTexture(te),j=te),n.bindTexture(U,se||Ee[U]),we.type=U,we.texture=se)}function F(){let U=ie[j];U!==void 0&&U.type!==void 0&&(n.bindTexture(U.type,null),U.type=void 0,U.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(U){je("WebGLState:",U)}}function $e(){try{n.compressedTexImage3D(...arguments)}catch(U){je("WebGLState:",U)}}function st(){try{n.texSubImage2D(...arguments)}catch(U){je("WebGLState:",U)}}function be(){try{n.texSubImage3D(...arguments)}catch(U){je("WebGLState:",U)}}function Dt(){try{n.compressedTexSubImage2D(...arguments)}catch(U){je("WebGLState:",U)}}function ze(){try{n.compressedTexSubImage3D(...arguments)}catch(U){je("WebGLState:",U)}}function qe(){try{n.texStorage2D(...arguments)}catch(U){je("WebGLState:",U)}}function E(){try{n.texStorage3D(...arguments)}catch(U){je("WebGLState:",U)}}function S(){try{n.texImage2D(...arguments)}catch(U){je("WebGLState:",U)}}function X(){try{n.texImage3D(...arguments)}catch(U){je("WebGLState:",U)}}function ce(U){return h[U]!==void 0?h[U]:n.getParameter(U)}function re(U,se){h[U]!==se&&(n.pixelStorei(U,se),h[U]=se)}function _e(U){Q.equals(U)===!1&&(n.scissor(U.x,U.y,U.z,U.w),Q.copy(U))}function ve(U){me.equals(U)===!1&&(n.viewport(U.x,U.y,U.z,U.w),me.copy(U))}function ee(U,se){let te=c.get(se);te===void 0&&(te=new WeakMap,c.set(se,te));let we=te.get(U);we===void 0&&(we=n.getUniformBlockIndex(se,U.name),n.uniformBlockBinding(se,we,we),te.set(U,we))}function ne(U,se,te){let ge=c.get(se).get(U);l[ge]!==te&&(n.bindBufferBase(n.UNIFORM_BUFFER,ge,te),l[ge]=te)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},j=null,ie={},f={},l={},p=new WeakMap,g=[],v=null,d=!1,m=null,y=null,C=null,b=null,P=null,A=null,x=null,T=new Xe(0,0,0),B=0,D=!1,I=null,k=null,V=null,N=null,H=null,Q.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Me,disable:He,bindFramebuffer:it,drawBuffers:Ve,useProgram:ct,setBlending:$t,setMaterial:Ot,setFlipSided:cn,setCullFace:It,setLineWidth:Tn,setPolygonOffset:vt,setScissorTest:vn,activeTexture:jt,bindTexture:un,unbindTexture:F,compressedTexImage2D:Re,compressedTexImage3D:$e,texImage2D:S,texImage3D:X,pixelStorei:re,getParameter:ce,updateUBOMapping:ee,uniformBlockBinding:ne,texStorage2D:qe,texStorage3D:E,texSubImage2D:st,texSubImage3D:be,compressedTexSubImage2D:Dt,compressedTexSubImage3D:ze,scissor:_e,viewport:ve,reset:pe}}function R1(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ut,u=new WeakMap,h=new Set,f,p=new WeakMap,g=new Set,v=new FinalizationRegistry(E=>g.delete(E)),d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(E,S){return d?new OffscreenCanvas(E,S):ca("canvas")}function y(E,S,X){let ce=1,re=qe(E);if((re.width>X||re.height>X)&&(ce=X/Math.max(re.width,re.height)),ce<1)if(typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&E instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&E instanceof ImageBitmap||typeof VideoFrame<"u"&&E instanceof VideoFrame){let _e=Math.floor(ce*re.width),ve=Math.floor(ce*re.height);f===void 0&&(f=m(_e,ve));let ee=S?m(_e,ve):f;return ee.width=_e,ee.height=ve,ee.getContext("2d").drawImage(E,0,0,_e,ve),Ye("WebGLRenderer: Texture has been resized from ("+re.width+"x"+re.height+") to ("+_e+"x"+ve+")."),ee}else return"data"in E&&Ye("WebGLRenderer: Image in DataTexture is too big ("+re.width+"x"+re.height+")."),E;return E}function C(E){return E.generateMipmaps}function b(E){n.generateMipmap(E)}function P(E){return E.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:E.isWebGL3DRenderTarget?n.TEXTURE_3D:E.isWebGLArrayRenderTarget||E.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(E,S,X,ce,re,_e=!1){if(E!==null){if(n[E]!==void 0)return n[E];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+E+"'")}let ve;ce&&(ve=e.get("EXT_texture_norm16"),ve||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ee=S;if(S===n.RED&&(X===n.FLOAT&&(ee=n.R32F),X===n.HALF_FLOAT&&(ee=n.R16F),X===n.UNSIGNED_BYTE&&(ee=n.R8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.R16_EXT),X===n.SHORT&&ve&&(ee=ve.R16_SNORM_EXT)),S===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.R8UI),X===n.UNSIGNED_SHORT&&(ee=n.R16UI),X===n.UNSIGNED_INT&&(ee=n.R32UI),X===n.BYTE&&(ee=n.R8I),X===n.SHORT&&(ee=n.R16I),X===n.INT&&(ee=n.R32I)),S===n.RG&&(X===n.FLOAT&&(ee=n.RG32F),X===n.HALF_FLOAT&&(ee=n.RG16F),X===n.UNSIGNED_BYTE&&(ee=n.RG8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RG16_EXT),X===n.SHORT&&ve&&(ee=ve.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RG8UI),X===n.UNSIGNED_SHORT&&(ee=n.RG16UI),X===n.UNSIGNED_INT&&(ee=n.RG32UI),X===n.BYTE&&(ee=n.RG8I),X===n.SHORT&&(ee=n.RG16I),X===n.INT&&(ee=n.RG32I)),S===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RGB8UI),X===n.UNSIGNED_SHORT&&(ee=n.RGB16UI),X===n.UNSIGNED_INT&&(ee=n.RGB32UI),X===n.BYTE&&(ee=n.RGB8I),X===n.SHORT&&(ee=n.RGB16I),X===n.INT&&(ee=n.RGB32I)),S===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(ee=n.RGBA16UI),X===n.UNSIGNED_INT&&(ee=n.RGBA32UI),X===n.BYTE&&(ee=n.RGBA8I),X===n.SHORT&&(ee=n.RGBA16I),X===n.INT&&(ee=n.RGBA32I)),S===n.RGB&&(X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RGB16_EXT),X===n.SHORT&&ve&&(ee=ve.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(ee=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(ee=n.R11F_G11F_B10F)),S===n.RGBA){let ne=_e?la:gt.getTransfer(re);X===n.FLOAT&&(ee=n.RGBA32F),X===n.HALF_FLOAT&&(ee=n.RGBA16F),X===n.UNSIGNED_BYTE&&(ee=ne===Tt?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RGBA16_EXT),X===n.SHORT&&ve&&(ee=ve.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(ee=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(ee=n.RGB5_A1)}return(ee===n.R16F||ee===n.R32F||ee===n.RG16F||ee===n.RG32F||ee===n.RGBA16F||ee===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function x(E,S){let X;return E?S===null||S===Fi||S===mr?X=n.DEPTH24_STENCIL8:S===Si?X=n.DEPTH32F_STENCIL8:S===yo&&(X=n.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Fi||S===mr?X=n.DEPTH_COMPONENT24:S===Si?X=n.DEPTH_COMPONENT32F:S===yo&&(X=n.DEPTH_COMPONENT16),X}function T(E,S){return C(E)===!0||E.isFramebufferTexture&&E.minFilter!==In&&E.minFilter!==Jn?Math.log2(Math.max(S.width,S.height))+1:E.mipmaps.length>0?E.mipmaps.length:E.isCompressedTexture&&Array.isArray(E.image)?S.mipmaps.length:1}function B(E){let S=new WeakRef(E);i.get(E).__ref=S,g.add(S),v.register(E,S,S)}function D(E){let S=i.get(E).__ref;S!==void 0&&(g.delete(S),v.unregister(S))}function I(E){V(E.target)}function k(E){N(E.target)}function V(E){E.removeEventListener("dispose",I),D(E),$(E),E.isVideoTexture&&u.delete(E),E.isHTMLTexture&&h.delete(E)}function N(E){E.removeEventListener("dispose",k),D(E),le(E)}function H(){for(let E of g){let S=E.deref();S!==void 0&&(S.isRenderTarget===!0?N(S):V(S))}g.clear(),h.clear()}function $(E){let S=i.get(E);if(S.__webglInit===void 0)return;let X=E.source,ce=p.get(X);if(ce){let re=ce[S.__cacheKey];re.usedTimes--,re.usedTimes===0&&G(E),Object.keys(ce).length===0&&p.delete(X)}i.remove(E)}function G(E){let S=i.get(E);n.deleteTexture(S.__webglTexture);let X=E.source,ce=p.get(X);delete ce[S.__cacheKey],o.memory.textures--}function le(E){let S=i.get(E);S.__depthDisposeCallback&&S.__depthDisposeCallback();let X=E.depthTexture;if(X&&X.renderTarget===E&&V(X),E.isWebGLCubeRenderTarget)for(let re=0;re<6;re++){if(Array.isArray(S.__webglFramebuffer[re]))for(let _e=0;_e<S.__webglFramebuffer[re].length;_e++)n.deleteFramebuffer(S.__webglFramebuffer[re][_e]);else n.deleteFramebuffer(S.__webglFramebuffer[re]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[re])}else{if(Array.isArray(S.__webglFramebuffer))for(let re=0;re<S.__webglFramebuffer.length;re++)n.deleteFramebuffer(S.__webglFramebuffer[re]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let re=0;re<S.__webglColorRenderbuffer.length;re++)S.__webglColorRenderbuffer[re]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[re]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ce=E.textures;for(let re=0,_e=ce.length;re<_e;re++){let ve=i.get(ce[re]);ve.__webglTexture&&(n.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(ce[re])}i.remove(E)}let J=0;function j(){J=0}function ie(){return J}function fe(E){J=E}function ue(){let E=J;return E>=s.maxTextures&&Ye("WebGLTextures: Trying to use "+(E+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,E}function Q(E){let S=[];return S.push(E.wrapS),S.push(E.wrapT),S.push(E.wrapR||0),S.push(E.magFilter),S.push(E.minFilter),S.push(E.anisotropy),S.push(E.internalFormat),S.push(E.format),S.push(E.type),S.push(E.generateMipmaps),S.push(E.mipmapsAutoUpdate),S.push(E.premultiplyAlpha),S.push(E.flipY),S.push(E.unpackAlignment),S.push(E.colorSpace),S.join()}function me(E,S){let X=i.get(E);if(E.isVideoTexture&&Dt(E),E.isRenderTargetTexture===!1&&E.isExternalTexture!==!0&&E.version>0&&X.__version!==E.version){let ce=E.image;if(ce===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(ce.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{Ot(X,E,S);return}}else E.isExternalTexture&&(X.__webglTexture=E.sourceTexture?E.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+S)}function xe(E,S){let X=i.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&X.__version!==E.version){Ot(X,E,S);return}else E.isExternalTexture&&(X.__webglTexture=E.sourceTexture?E.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+S)}function Ee(E,S){let X=i.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&X.__version!==E.version){Ot(X,E,S);return}t.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+S)}function Me(E,S){let X=i.get(E);if(E.version>0&&X.__version!==E.version){cn(X,E,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+S)}let He={[jl]:n.REPEAT,[Ji]:n.CLAMP_TO_EDGE,[Ql]:n.MIRRORED_REPEAT},it={[In]:n.NEAREST,[_m]:n.NEAREST_MIPMAP_NEAREST,[Ia]:n.NEAREST_MIPMAP_LINEAR,[Jn]:n.LINEAR,[Ec]:n.LINEAR_MIPMAP_NEAREST,[Ss]:n.LINEAR_MIPMAP_LINEAR},Ve={[Sm]:n.NEVER,[hf]:n.ALWAYS,[Mm]:n.LESS,[cf]:n.LEQUAL,[bm]:n.EQUAL,[uf]:n.GEQUAL,[wm]:n.GREATER,[Tm]:n.NOTEQUAL};function ct(E,S){if(S.type===Si&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===Jn||S.magFilter===Ec||S.magFilter===Ia||S.magFilter===Ss||S.minFilter===Jn||S.minFilter===Ec||S.minFilter===Ia||S.minFilter===Ss)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(E,n.TEXTURE_WRAP_S,He[S.wrapS]),n.texParameteri(E,n.TEXTURE_WRAP_T,He[S.wrapT]),(E===n.TEXTURE_3D||E===n.TEXTURE_2D_ARRAY)&&n.texParameteri(E,n.TEXTURE_WRAP_R,He[S.wrapR]),n.texParameteri(E,n.TEXTURE_MAG_FILTER,it[S.magFilter]),n.texParameteri(E,n.TEXTURE_MIN_FILTER,it[S.minFilter]),S.compareFunction&&(n.texParameteri(E,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(E,n.TEXTURE_COMPARE_FUNC,Ve[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===In||S.minFilter!==Ia&&S.minFilter!==Ss||S.type===Si&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");n.texParameterf(E,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function ot(E,S){let X=!1;E.__webglInit===void 0&&(E.__webglInit=!0,S.addEventListener("dispose",I),B(S));let ce=S.source,re=p.get(ce);re===void 0&&(re={},p.set(ce,re));let _e=Q(S);if(_e!==E.__cacheKey){re[_e]===void 0&&(re[_e]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),re[_e].usedTimes++;let ve=re[E.__cacheKey];ve!==void 0&&(re[E.__cacheKey].usedTimes--,ve.usedTimes===0&&G(S)),E.__cacheKey=_e,E.__webglTexture=re[_e].texture}return X}function tt(E,S,X){return Math.floor(Math.floor(E/X)/S)}function $t(E,S,X,ce){let _e=E.updateRanges;if(_e.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,X,ce,S.data);else{_e.sort((U,se)=>U.start-se.start);let ve=0;for(let U=1;U<_e.length;U++){let se=_e[ve],te=_e[U],we=se.start+se.count,ge=tt(te.start,S.width,4),Se=tt(se.start,S.width,4);te.start<=we+1&&ge===Se&&tt(te.start+te.count-1,S.width,4)===ge?se.count=Math.max(se.count,te.start+te.count-se.start):(++ve,_e[ve]=te)}_e.length=ve+1;let ee=t.getParameter(n.UNPACK_ROW_LENGTH),ne=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let U=0,se=_e.length;U<se;U++){let te=_e[U],we=Math.floor(te.start/4),ge=Math.ceil(te.count/4),Se=we%S.width,Ge=Math.floor(we/S.width),Je=ge,ae=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,Ge),t.texSubImage2D(n.TEXTURE_2D,0,Se,Ge,Je,ae,X,ce,S.data)}E.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ee),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ne),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Ot(E,S,X){let ce=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ce=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ce=n.TEXTURE_3D);let re=ot(E,S),_e=S.source;t.bindTexture(ce,E.__webglTexture,n.TEXTURE0+X);let ve=i.get(_e);if(_e.version!==ve.__version||re===!0){if(t.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ae=gt.getPrimaries(gt.workingColorSpace),Oe=S.colorSpace===bs?null:gt.getPrimaries(S.colorSpace),Ke=S.colorSpace===bs||ae===Oe?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ke)}t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let ne=y(S.image,!1,s.maxTextureSize);ne=ze(S,ne);let pe=r.convert(S.format,S.colorSpace),U=r.convert(S.type),se=A(S.internalFormat,pe,U,S.normalized,S.colorSpace,S.isVideoTexture);ct(ce,S);let te,we=S.mipmaps,ge=S.isVideoTexture!==!0,Se=ve.__version===void 0||re===!0,Ge=_e.dataReady,Je=T(S,ne);if(S.isDepthTexture)se=x(S.format===Ms,S.type),Se&&(ge?t.texStorage2D(n.TEXTURE_2D,1,se,ne.width,ne.height):t.texImage2D(n.TEXTURE_2D,0,se,ne.width,ne.height,0,pe,U,null));else if(S.isDataTexture)if(we.length>0){ge&&Se&&t.texStorage2D(n.TEXTURE_2D,Je,se,we[0].width,we[0].height);for(let ae=0,Oe=we.length;ae<Oe;ae++)te=we[ae],ge?Ge&&t.texSubImage2D(n.TEXTURE_2D,ae,0,0,te.width,te.height,pe,U,te.data):t.texImage2D(n.TEXTURE_2D,ae,se,te.width,te.height,0,pe,U,te.data);S.generateMipmaps=!1}else ge?(Se&&t.texStorage2D(n.TEXTURE_2D,Je,se,ne.width,ne.height),Ge&&$t(S,ne,pe,U)):t.texImage2D(n.TEXTURE_2D,0,se,ne.width,ne.height,0,pe,U,ne.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){ge&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,se,we[0].width,we[0].height,ne.depth);for(let ae=0,Oe=we.length;ae<Oe;ae++)if(te=we[ae],S.format!==ni)if(pe!==null)if(ge){if(Ge)if(S.layerUpdates.size>0){let Ke=xf(te.width,te.height,S.format,S.type);for(let Ce of S.layerUpdates){let rt=te.data.subarray(Ce*Ke/te.data.BYTES_PER_ELEMENT,(Ce+1)*Ke/te.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ae,0,0,Ce,te.width,te.height,1,pe,rt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ae,0,0,0,te.width,te.height,ne.depth,pe,te.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ae,se,te.width,te.height,ne.depth,0,te.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?Ge&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ae,0,0,0,te.width,te.height,ne.depth,pe,U,te.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ae,se,te.width,te.height,ne.depth,0,pe,U,te.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{ge&&Se&&t.texStorage2D(n.TEXTURE_2D,Je,se,we[0].width,we[0].height);for(let ae=0,Oe=we.length;ae<Oe;ae++)te=we[ae],S.format!==ni?pe!==null?ge?Ge&&t.compressedTexSubImage2D(n.TEXTURE_2D,ae,0,0,te.width,te.height,pe,te.data):t.compressedTexImage2D(n.TEXTURE_2D,ae,se,te.width,te.height,0,te.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?Ge&&t.texSubImage2D(n.TEXTURE_2D,ae,0,0,te.width,te.height,pe,U,te.data):t.texImage2D(n.TEXTURE_2D,ae,se,te.width,te.height,0,pe,U,te.data)}else if(S.isDataArrayTexture)if(ge){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,se,ne.width,ne.height,ne.depth),Ge)if(S.layerUpdates.size>0){let ae=xf(ne.width,ne.height,S.format,S.type);for(let Oe of S.layerUpdates){let Ke=ne.data.subarray(Oe*ae/ne.data.BYTES_PER_ELEMENT,(Oe+1)*ae/ne.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Oe,ne.width,ne.height,1,pe,U,Ke)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,ne.depth,pe,U,ne.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,se,ne.width,ne.height,ne.depth,0,pe,U,ne.data);else if(S.isData3DTexture)ge?(Se&&t.texStorage3D(n.TEXTURE_3D,Je,se,ne.width,ne.height,ne.depth),Ge&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,pe,U,ne.data)):t.texImage3D(n.TEXTURE_3D,0,se,ne.width,ne.height,ne.depth,0,pe,U,ne.data);else if(S.isFramebufferTexture){if(Se)if(ge)t.texStorage2D(n.TEXTURE_2D,Je,se,ne.width,ne.height);else{let ae=ne.width,Oe=ne.height;for(let Ke=0;Ke<Je;Ke++)t.texImage2D(n.TEXTURE_2D,Ke,se,ae,Oe,0,pe,U,null),ae>>=1,Oe>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let ae=n.canvas;if(ae.hasAttribute("layoutsubtree")||ae.setAttribute("layoutsubtree","true"),ne.parentNode!==ae){ae.appendChild(ne),h.add(S),ae.onpaint=Oe=>{let Ke=Oe.changedElements;for(let Ce of h)Ke.includes(Ce.image)&&(Ce.needsUpdate=!0)},ae.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ne);else{let Ke=n.RGBA,Ce=n.RGBA,rt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Ke,Ce,rt,ne)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(we.length>0){if(ge&&Se){let ae=qe(we[0]);t.texStorage2D(n.TEXTURE_2D,Je,se,ae.width,ae.height)}for(let ae=0,Oe=we.length;ae<Oe;ae++)te=we[ae],ge?Ge&&t.texSubImage2D(n.TEXTURE_2D,ae,0,0,pe,U,te):t.texImage2D(n.TEXTURE_2D,ae,se,pe,U,te);S.generateMipmaps=!1}else if(ge){if(Se){let ae=qe(ne);t.texStorage2D(n.TEXTURE_2D,Je,se,ae.width,ae.height)}Ge&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,U,ne)}else t.texImage2D(n.TEXTURE_2D,0,se,pe,U,ne);C(S)&&S.mipmapsAutoUpdate===!0&&b(ce),ve.__version=_e.version,S.onUpdate&&S.onUpdate(S)}E.__version=S.version}function cn(E,S,X){if(S.image.length!==6)return;let ce=ot(E,S),re=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,E.__webglTexture,n.TEXTURE0+X);let _e=i.get(re);if(re.version!==_e.__version||ce===!0){t.activeTexture(n.TEXTURE0+X);let ve=gt.getPrimaries(gt.workingColorSpace),ee=S.colorSpace===bs?null:gt.getPrimaries(S.colorSpace),ne=S.colorSpace===bs||ve===ee?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let pe=S.isCompressedTexture||S.image[0].isCompressedTexture,U=S.image[0]&&S.image[0].isDataTexture,se=[];for(let Ce=0;Ce<6;Ce++)!pe&&!U?se[Ce]=y(S.image[Ce],!0,s.maxCubemapSize):se[Ce]=U?S.image[Ce].image:S.image[Ce],se[Ce]=ze(S,se[Ce]);let te=se[0],we=r.convert(S.format,S.colorSpace),ge=r.convert(S.type),Se=A(S.internalFormat,we,ge,S.normalized,S.colorSpace),Ge=S.isVideoTexture!==!0,Je=_e.__version===void 0||ce===!0,ae=re.dataReady,Oe=T(S,te);ct(n.TEXTURE_CUBE_MAP,S);let Ke;if(S.isDepthTexture){if(Se=x(S.format===Ms,S.type),Je)if(Ge)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,te.width,te.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,te.width,te.height,0,we,ge,null)}else if(pe){Ge&&Je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Oe,Se,te.width,te.height);for(let Ce=0;Ce<6;Ce++){Ke=se[Ce].mipmaps;for(let rt=0;rt<Ke.length;rt++){let zt=Ke[rt];S.format!==ni?we!==null?Ge?ae&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt,0,0,zt.width,zt.height,we,zt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt,Se,zt.width,zt.height,0,zt.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ge?ae&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt,0,0,zt.width,zt.height,we,ge,zt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt,Se,zt.width,zt.height,0,we,ge,zt.data)}}}else{if(Ke=S.mipmaps,Ge&&Je){Ke.length>0&&Oe++;let Ce=qe(se[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Oe,Se,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(U){Ge?ae&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,se[Ce].width,se[Ce].height,we,ge,se[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,se[Ce].width,se[Ce].height,0,we,ge,se[Ce].data);for(let rt=0;rt<Ke.length;rt++){let Hn=Ke[rt].image[Ce].image;Ge?ae&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt+1,0,0,Hn.width,Hn.height,we,ge,Hn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt+1,Se,Hn.width,Hn.height,0,we,ge,Hn.data)}}else{Ge?ae&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,we,ge,se[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,we,ge,se[Ce]);for(let rt=0;rt<Ke.length;rt++){let zt=Ke[rt];Ge?ae&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt+1,0,0,we,ge,zt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt+1,Se,we,ge,zt.image[Ce])}}}C(S)&&S.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),_e.__version=re.version,S.onUpdate&&S.onUpdate(S)}E.__version=S.version}function It(E,S,X,ce,re,_e){let ve=r.convert(X.format,X.colorSpace),ee=r.convert(X.type),ne=A(X.internalFormat,ve,ee,X.normalized,X.colorSpace),pe=i.get(S),U=i.get(X);if(U.__renderTarget=S,!pe.__hasExternalTextures){let se=Math.max(1,S.width>>_e),te=Math.max(1,S.height>>_e);re===n.TEXTURE_3D||re===n.TEXTURE_2D_ARRAY?t.texImage3D(re,_e,ne,se,te,S.depth,0,ve,ee,null):t.texImage2D(re,_e,ne,se,te,0,ve,ee,null)}t.bindFramebuffer(n.FRAMEBUFFER,E),be(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ce,re,U.__webglTexture,0,st(S)):(re===n.TEXTURE_2D||re>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&re<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ce,re,U.__webglTexture,_e),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Tn(E,S,X){if(n.bindRenderbuffer(n.RENDERBUFFER,E),S.depthBuffer){let ce=S.depthTexture,re=ce&&ce.isDepthTexture?ce.type:null,_e=x(S.stencilBuffer,re),ve=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;be(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,st(S),_e,S.width,S.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,st(S),_e,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,_e,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ve,n.RENDERBUFFER,E)}else{let ce=S.textures;for(let re=0;re<ce.length;re++){let _e=ce[re],ve=r.convert(_e.format,_e.colorSpace),ee=r.convert(_e.type),ne=A(_e.internalFormat,ve,ee,_e.normalized,_e.colorSpace);be(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,st(S),ne,S.width,S.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,st(S),ne,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,ne,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function vt(E,S,X){let ce=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,E),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let re=i.get(S.depthTexture);re.__renderTarget=S;let _e=ce?S.depthTexture.image[0]:S.depthTexture.image;(!re.__webglTexture||_e.width!==S.width||_e.height!==S.height)&&(_e.width=S.width,_e.height=S.height,S.depthTexture.needsUpdate=!0),ce?Me(S.depthTexture,0):me(S.depthTexture,0);let ve=re.__webglTexture,ee=st(S),ne=ce?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,pe=S.depthTexture.format===Ms?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===_s)be(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ne,ve,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ne,ve,0);else if(S.depthTexture.format===Ms)be(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ne,ve,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ne,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function vn(E){let S=i.get(E),X=E.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==E.depthTexture){let ce=E.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ce){let re=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ce.removeEventListener("dispose",re)};ce.addEventListener("dispose",re),S.__depthDisposeCallback=re}S.__boundDepthTexture=ce}if(E.depthTexture&&!S.__autoAllocateDepthBuffer)if(X)for(let ce=0;ce<6;ce++)vt(S.__webglFramebuffer[ce],E,ce);else E.texture.mipmaps.length>0?vt(S.__webglFramebuffer[0],E,0):vt(S.__webglFramebuffer,E,0);else if(X){S.__webglDepthbuffer=[];for(let ce=0;ce<6;ce++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[ce]),S.__webglDepthbuffer[ce]===void 0)S.__webglDepthbuffer[ce]=n.createRenderbuffer(),Tn(S.__webglDepthbuffer[ce],E,!1);else{let re=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=S.__webglDepthbuffer[ce];n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,re,n.RENDERBUFFER,_e)}}else if(E.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),Tn(S.__webglDepthbuffer,E,!1);else{let re=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,re,n.RENDERBUFFER,_e)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function jt(E,S,X){let ce=i.get(E);S!==void 0&&It(ce.__webglFramebuffer,E,E.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&vn(E)}function un(E){let S=E.texture,X=i.get(E),ce=i.get(S);E.addEventListener("dispose",k),B(E);let re=E.textures,_e=E.isWebGLCubeRenderTarget===!0,ve=re.length>1;if(ve||(ce.__webglTexture===void 0&&(ce.__webglTexture=n.createTexture()),ce.__version=S.version,o.memory.textures++),_e){X.__webglFramebuffer=[];for(let ee=0;ee<6;ee++)if(S.mipmaps.length>0){X.__webglFramebuffer[ee]=[];for(let ne=0;ne<S.mipmaps.length;ne++)X.__webglFramebuffer[ee][ne]=n.createFramebuffer()}else X.__webglFramebuffer[ee]=n.createFramebuffer()}else{if(S.mipmaps.length>0){X.__webglFramebuffer=[];for(let ee=0;ee<S.mipmaps.length;ee++)X.__webglFramebuffer[ee]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(ve)for(let ee=0,ne=re.length;ee<ne;ee++){let pe=i.get(re[ee]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(E.samples>0&&be(E)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let ee=0;ee<re.length;ee++){let ne=re[ee];X.__webglColorRenderbuffer[ee]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[ee]);let pe=r.convert(ne.format,ne.colorSpace),U=r.convert(ne.type),se=A(ne.internalFormat,pe,U,ne.normalized,ne.colorSpace,E.isXRRenderTarget===!0),te=st(E);n.renderbufferStorageMultisample(n.RENDERBUFFER,te,se,E.width,E.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ee,n.RENDERBUFFER,X.__webglColorRenderbuffer[ee])}n.bindRenderbuffer(n.RENDERBUFFER,null),E.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),Tn(X.__webglDepthRenderbuffer,E,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_e){t.bindTexture(n.TEXTURE_CUBE_MAP,ce.__webglTexture),ct(n.TEXTURE_CUBE_MAP,S);for(let ee=0;ee<6;ee++)if(S.mipmaps.length>0)for(let ne=0;ne<S.mipmaps.length;ne++)It(X.__webglFramebuffer[ee][ne],E,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ee,ne);else It(X.__webglFramebuffer[ee],E,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ee,0);C(S)?b(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let ee=0,ne=re.length;ee<ne;ee++){let pe=re[ee],U=i.get(pe),se=n.TEXTURE_2D;(E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(se=E.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(se,U.__webglTexture),ct(se,pe),It(X.__webglFramebuffer,E,pe,n.COLOR_ATTACHMENT0+ee,se,0),C(pe)&&b(se)}t.unbindTexture()}else{let ee=n.TEXTURE_2D;if((E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(ee=E.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ee,ce.__webglTexture),ct(ee,S),S.mipmaps.length>0)for(let ne=0;ne<S.mipmaps.length;ne++)It(X.__webglFramebuffer[ne],E,S,n.COLOR_ATTACHMENT0,ee,ne);else It(X.__webglFramebuffer,E,S,n.COLOR_ATTACHMENT0,ee,0);C(S)?b(ee):S.mipmaps.length>0&&n.texParameteri(ee,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}E.depthBuffer&&vn(E)}function F(E){let S=E.textures;for(let X=0,ce=S.length;X<ce;X++){let re=S[X];if(C(re)&&re.mipmapsAutoUpdate===!0){let _e=P(E),ve=i.get(re).__webglTexture;t.bindTexture(_e,ve),b(_e),t.unbindTexture()}}}let Re=[];function $e(E){if(E.samples>0){if(be(E)===!1){let S=E.textures,X=E.width,ce=E.height,re=n.COLOR_BUFFER_BIT,_e=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=i.get(E),ee=S.length>1;if(ee)for(let pe=0;pe<S.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),E.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let pe=0;pe<S.length;pe++){if(E.resolveDepthBuffer&&(E.depthBuffer&&(re|=n.DEPTH_BUFFER_BIT),E.stencilBuffer&&E.resolveStencilBuffer&&(re|=n.STENCIL_BUFFER_BIT)),ee){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let U=i.get(S[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,U,0)}n.blitFramebuffer(0,0,X,ce,0,0,X,ce,re,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+pe),E.depthBuffer&&E.storeMultisampledDepthBuffer===!1&&Re.push(_e),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ee)for(let pe=0;pe<S.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let U=i.get(S[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,U,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(E.depthBuffer&&E.storeMultisampledDepthBuffer===!1&&l){let S=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function st(E){return Math.min(s.maxSamples,E.samples)}function be(E){let S=i.get(E);return E.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Dt(E){let S=o.render.frame;u.get(E)!==S&&(u.set(E,S),E.update())}function ze(E,S){let X=E.colorSpace,ce=E.format,re=E.type;return E.isCompressedTexture===!0||E.isVideoTexture===!0||X!==aa&&X!==bs&&(gt.getTransfer(X)===Tt?(ce!==ni||re!==zn)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):je("WebGLTextures: Unsupported texture color space:",X)),S}function qe(E){return typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement?(c.width=E.naturalWidth||E.width,c.height=E.naturalHeight||E.height):typeof VideoFrame<"u"&&E instanceof VideoFrame?(c.width=E.displayWidth,c.height=E.displayHeight):(c.width=E.width,c.height=E.height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=j,this.getTextureUnits=ie,this.setTextureUnits=fe,this.setTexture2D=me,this.setTexture2DArray=xe,this.setTexture3D=Ee,this.setTextureCube=Me,this.rebindTextures=jt,this.setupRenderTarget=un,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=$e,this.setupDepthRenderbuffer=vn,this.setupFrameBufferTexture=It,this.useMultisampledRTT=be,this.dispose=H}function P1(n,e){function t(i,s=bs){let r,o=gt.getTransfer(s);if(i===zn)return n.UNSIGNED_BYTE;if(i===Rc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Pc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===rf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===of)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===nf)return n.BYTE;if(i===sf)return n.SHORT;if(i===yo)return n.UNSIGNED_SHORT;if(i===Cc)return n.INT;if(i===Fi)return n.UNSIGNED_INT;if(i===Si)return n.FLOAT;if(i===Oi)return n.HALF_FLOAT;if(i===af)return n.ALPHA;if(i===lf)return n.RGB;if(i===ni)return n.RGBA;if(i===_s)return n.DEPTH_COMPONENT;if(i===Ms)return n.DEPTH_STENCIL;if(i===So)return n.RED;if(i===Ic)return n.RED_INTEGER;if(i===Bi)return n.RG;if(i===Lc)return n.RG_INTEGER;if(i===Nc)return n.RGBA_INTEGER;if(i===La||i===Na||i===Da||i===Ua)if(o===Tt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===La)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Na)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Da)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ua)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===La)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Na)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Da)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ua)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Dc||i===Uc||i===Fc||i===Oc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Dc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Uc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Fc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Oc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Bc||i===kc||i===zc||i===Vc||i===Gc||i===Fa||i===Hc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Bc||i===kc)return o===Tt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===zc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Vc)return r.COMPRESSED_R11_EAC;if(i===Gc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Fa)return r.COMPRESSED_RG11_EAC;if(i===Hc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Wc||i===Xc||i===qc||i===$c||i===Yc||i===Zc||i===Jc||i===Kc||i===jc||i===Qc||i===eu||i===tu||i===nu||i===iu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Wc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Xc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===qc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===$c)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Yc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Zc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Jc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Kc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===jc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Qc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===eu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===tu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===nu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===iu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===su||i===ru||i===ou)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===su)return o===Tt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===ru)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===ou)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===au||i===lu||i===Oa||i===cu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===au)return r.COMPRESSED_RED_RGTC1_EXT;if(i===lu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Oa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===cu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===mr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var I1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,L1=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Ef=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new va(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new ti({vertexShader:I1,fragmentShader:L1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new kt(new ur(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Cf=class extends Ki{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,p=null,g=null,v=typeof XRWebGLBinding<"u",d=new Ef,m={},y=t.getContextAttributes(),C=null,b=null,P=[],A=[],x=new ut,T=null,B=null,D=new Zn;D.viewport=new Bt;let I=new Zn;I.viewport=new Bt;let k=[D,I],V=new bc,N=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let me=P[Q];return me===void 0&&(me=new co,P[Q]=me),me.getTargetRaySpace()},this.getControllerGrip=function(Q){let me=P[Q];return me===void 0&&(me=new co,P[Q]=me),me.getGripSpace()},this.getHand=function(Q){let me=P[Q];return me===void 0&&(me=new co,P[Q]=me),me.getHandSpace()};function $(Q){let me=A.indexOf(Q.inputSource);if(me===-1)return;let xe=P[me];xe!==void 0&&(xe.update(Q.inputSource,Q.frame,c||o),xe.dispatchEvent({type:Q.type,data:Q.inputSource}))}function G(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",le);for(let Q=0;Q<P.length;Q++){let me=A[Q];me!==null&&(A[Q]=null,P[Q].disconnect(me))}N=null,H=null,d.reset();for(let Q in m)delete m[Q];if(e.setRenderTarget(C),p=null,f=null,h=null,s=null,b=null,ue.stop(),i.isPresenting=!1,e.setPixelRatio(T),e.setSize(x.width,x.height,!1),B!==null){let Q=B.camera;Q.fov=B.fov,Q.zoom=B.zoom,Q.updateProjectionMatrix(),B=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,i.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,i.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return h===null&&v&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(C=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",G),s.addEventListener("inputsourceschange",le),y.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(x),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let xe=null,Ee=null,Me=null;y.depth&&(Me=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,xe=y.stencil?Ms:_s,Ee=y.stencil?mr:Fi);let He={colorFormat:t.RGBA8,depthFormat:Me,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(He),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),b=new ui(f.textureWidth,f.textureHeight,{format:ni,type:zn,depthTexture:new vs(f.textureWidth,f.textureHeight,Ee,void 0,void 0,void 0,void 0,void 0,void 0,xe),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let xe={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,t,xe),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),b=new ui(p.framebufferWidth,p.framebufferHeight,{format:ni,type:zn,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ue.setContext(s),ue.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return d.getDepthTexture()};function le(Q){for(let me=0;me<Q.removed.length;me++){let xe=Q.removed[me],Ee=A.indexOf(xe);Ee>=0&&(A[Ee]=null,P[Ee].disconnect(xe))}for(let me=0;me<Q.added.length;me++){let xe=Q.added[me],Ee=A.indexOf(xe);if(Ee===-1){for(let He=0;He<P.length;He++)if(He>=A.length){A.push(xe),Ee=He;break}else if(A[He]===null){A[He]=xe,Ee=He;break}if(Ee===-1)break}let Me=P[Ee];Me&&Me.connect(xe)}}function J(Q,me){me===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(me.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let me=Q.near,xe=Q.far;d.texture!==null&&(d.depthNear>0&&(me=d.depthNear),d.depthFar>0&&(xe=d.depthFar)),V.near=I.near=D.near=me,V.far=I.far=D.far=xe,(N!==V.near||H!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),N=V.near,H=V.far),V.layers.mask=Q.layers.mask|6,D.layers.mask=V.layers.mask&-5,I.layers.mask=V.layers.mask&-3;let Ee=Q.parent,Me=V.cameras;J(V,Ee);for(let He=0;He<Me.length;He++)J(Me[He],Ee);V.projectionMatrix.copy(D.projectionMatrix),V.projectionMatrixInverse.copy(D.projectionMatrixInverse),B===null&&Q.isPerspectiveCamera&&(B={camera:Q,fov:Q.fov,zoom:Q.zoom}),j(Q,V,Ee)};function j(Q,me,xe){xe===null?Q.matrix.copy(me.matrixWorld):(Q.matrix.copy(xe.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(me.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(me.projectionMatrix),Q.projectionMatrixInverse.copy(me.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=tc*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(Q){l=Q,f!==null&&(f.fixedFoveation=Q),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=Q)},this.hasDepthSensing=function(){return d.texture!==null},this.getDepthSensingMesh=function(){return d.getMesh(V)},this.getCameraTexture=function(Q){return m[Q]};let ie=null;function fe(Q,me){if(u=me.getViewerPose(c||o),g=me,u!==null){let xe=u.views;p!==null&&(e.setRenderTargetFramebuffer(b,p.framebuffer),e.setRenderTarget(b));let Ee=!1;xe.length!==V.cameras.length&&(V.cameras.length=0,Ee=!0);for(let Ve=0;Ve<xe.length;Ve++){let ct=xe[Ve],ot=null;if(p!==null)ot=p.getViewport(ct);else{let $t=h.getViewSubImage(f,ct);ot=$t.viewport,Ve===0&&(e.setRenderTargetTextures(b,$t.colorTexture,$t.depthStencilTexture),e.setRenderTarget(b))}let tt=k[Ve];tt===void 0&&(tt=new Zn,tt.layers.enable(Ve),tt.viewport=new Bt,k[Ve]=tt),tt.matrix.fromArray(ct.transform.matrix),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.projectionMatrix.fromArray(ct.projectionMatrix),tt.projectionMatrixInverse.copy(tt.projectionMatrix).invert(),tt.viewport.set(ot.x,ot.y,ot.width,ot.height),Ve===0&&(V.matrix.copy(tt.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Ee===!0&&V.cameras.push(tt)}let Me=s.enabledFeatures;if(Me&&Me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){h=i.getBinding();let Ve=h.getDepthInformation(xe[0]);Ve&&Ve.isValid&&Ve.texture&&d.init(Ve,s.renderState)}if(Me&&Me.includes("camera-access")&&v){e.state.unbindTexture(),h=i.getBinding();for(let Ve=0;Ve<xe.length;Ve++){let ct=xe[Ve].camera;if(ct){let ot=m[ct];ot||(ot=new va,m[ct]=ot);let tt=h.getCameraImage(ct);ot.sourceTexture=tt}}}}for(let xe=0;xe<P.length;xe++){let Ee=A[xe],Me=P[xe];Ee!==null&&Me!==void 0&&Me.update(Ee,me,c||o)}ie&&ie(Q,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),g=null}let ue=new ig;ue.setAnimationLoop(fe),this.setAnimationLoop=function(Q){ie=Q},this.dispose=function(){}}},N1=new yt,dg=new et;dg.set(-1,0,0,0,1,0,0,0,1);function D1(n,e){function t(d,m){d.matrixAutoUpdate===!0&&d.updateMatrix(),m.value.copy(d.matrix)}function i(d,m){m.color.getRGB(d.fogColor.value,mf(n)),m.isFog?(d.fogNear.value=m.near,d.fogFar.value=m.far):m.isFogExp2&&(d.fogDensity.value=m.density)}function s(d,m,y,C,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(d,m):m.isMeshLambertMaterial?(r(d,m),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(d,m),h(d,m)):m.isMeshPhongMaterial?(r(d,m),u(d,m),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(d,m),f(d,m),m.isMeshPhysicalMaterial&&p(d,m,b)):m.isMeshMatcapMaterial?(r(d,m),g(d,m)):m.isMeshDepthMaterial?r(d,m):m.isMeshDistanceMaterial?(r(d,m),v(d,m)):m.isMeshNormalMaterial?r(d,m):m.isLineBasicMaterial?(o(d,m),m.isLineDashedMaterial&&a(d,m)):m.isPointsMaterial?l(d,m,y,C):m.isSpriteMaterial?c(d,m):m.isShadowMaterial?(d.color.value.copy(m.color),d.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(d,m){d.opacity.value=m.opacity,m.color&&d.diffuse.value.copy(m.color),m.emissive&&d.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(d.map.value=m.map,t(m.map,d.mapTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,t(m.alphaMap,d.alphaMapTransform)),m.bumpMap&&(d.bumpMap.value=m.bumpMap,t(m.bumpMap,d.bumpMapTransform),d.bumpScale.value=m.bumpScale,m.side===Kn&&(d.bumpScale.value*=-1)),m.normalMap&&(d.normalMap.value=m.normalMap,t(m.normalMap,d.normalMapTransform),d.normalScale.value.copy(m.normalScale),m.side===Kn&&d.normalScale.value.negate()),m.displacementMap&&(d.displacementMap.value=m.displacementMap,t(m.displacementMap,d.displacementMapTransform),d.displacementScale.value=m.displacementScale,d.displacementBias.value=m.displacementBias),m.emissiveMap&&(d.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,d.emissiveMapTransform)),m.specularMap&&(d.specularMap.value=m.specularMap,t(m.specularMap,d.specularMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest);let y=e.get(m),C=y.envMap,b=y.envMapRotation;C&&(d.envMap.value=C,d.envMapRotation.value.setFromMatrix4(N1.makeRotationFromEuler(b)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&d.envMapRotation.value.premultiply(dg),d.reflectivity.value=m.reflectivity,d.ior.value=m.ior,d.refractionRatio.value=m.refractionRatio),m.lightMap&&(d.lightMap.value=m.lightMap,d.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,d.lightMapTransform)),m.aoMap&&(d.aoMap.value=m.aoMap,d.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,d.aoMapTransform))}function o(d,m){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,m.map&&(d.map.value=m.map,t(m.map,d.mapTransform))}function a(d,m){d.dashSize.value=m.dashSize,d.totalSize.value=m.dashSize+m.gapSize,d.scale.value=m.scale}function l(d,m,y,C){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,d.size.value=m.size*y,d.scale.value=C*.5,m.map&&(d.map.value=m.map,t(m.map,d.uvTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,t(m.alphaMap,d.alphaMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest)}function c(d,m){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,d.rotation.value=m.rotation,m.map&&(d.map.value=m.map,t(m.map,d.mapTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,t(m.alphaMap,d.alphaMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest)}function u(d,m){d.specular.value.copy(m.specular),d.shininess.value=Math.max(m.shininess,1e-4)}function h(d,m){m.gradientMap&&(d.gradientMap.value=m.gradientMap)}function f(d,m){d.metalness.value=m.metalness,m.metalnessMap&&(d.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,d.metalnessMapTransform)),d.roughness.value=m.roughness,m.roughnessMap&&(d.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,d.roughnessMapTransform)),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)}function p(d,m,y){d.ior.value=m.ior,m.diffuseRoughness>0&&(d.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(d.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,d.diffuseRoughnessMapTransform))),m.sheen>0&&(d.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),d.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(d.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,d.sheenColorMapTransform)),m.sheenRoughnessMap&&(d.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,d.sheenRoughnessMapTransform))),m.clearcoat>0&&(d.clearcoat.value=m.clearcoat,d.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(d.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,d.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(d.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,d.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(d.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,d.clearcoatNormalMapTransform),d.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Kn&&d.clearcoatNormalScale.value.negate())),m.dispersion>0&&(d.dispersion.value=m.dispersion),m.retroreflectivity>0&&(d.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(d.iridescence.value=m.iridescence,d.iridescenceIOR.value=m.iridescenceIOR,d.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,d.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(d.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,d.iridescenceMapTransform)),m.iridescenceThicknessMap&&(d.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,d.iridescenceThicknessMapTransform))),m.transmission>0&&(d.transmission.value=m.transmission,d.transmissionSamplerMap.value=y.texture,d.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(d.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,d.transmissionMapTransform)),d.thickness.value=m.thickness,m.thicknessMap&&(d.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,d.thicknessMapTransform)),d.attenuationDistance.value=m.attenuationDistance,d.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(d.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(d.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,d.anisotropyMapTransform))),d.specularIntensity.value=m.specularIntensity,d.specularColor.value.copy(m.specularColor),m.specularColorMap&&(d.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,d.specularColorMapTransform)),m.specularIntensityMap&&(d.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,d.specularIntensityMapTransform))}function g(d,m){m.matcap&&(d.matcap.value=m.matcap)}function v(d,m){let y=e.get(m).light;d.referencePosition.value.setFromMatrixPosition(y.matrixWorld),d.nearDistance.value=y.shadow.camera.near,d.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function U1(n,e,t,i){let s={},r={};function o(y,C){let b=C.program;i.uniformBlockBinding(y,b,s[y.id])}function a(y,C){let b=s[y.id];b===void 0&&(g(y),b=l(y),s[y.id]=b,y.addEventListener("dispose",d));let P=C.program;i.updateUBOMapping(y,P);let A=e.render.frame;r[y.id]!==A&&(c(y),r[y.id]=A)}function l(y){let C=n.createBuffer(),b=y.__size,P=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,C),n.bufferData(n.UNIFORM_BUFFER,b,P),n.bindBuffer(n.UNIFORM_BUFFER,null),C}function c(y){let C=s[y.id],b=y.uniforms,P=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,C);for(let A=0,x=b.length;A<x;A++){let T=b[A];if(Array.isArray(T))for(let B=0,D=T.length;B<D;B++)u(T[B],A,B,P);else u(T,A,0,P)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(y,C,b,P){if(f(y,C,b,P)===!0){let A=y.__offset,x=y.value;if(Array.isArray(x)){let T=0;for(let B=0;B<x.length;B++){let D=x[B],I=v(D,!0);h(D,y.__data,T),T+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else h(x,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,y.__data)}}function h(y,C,b){typeof y=="number"||typeof y=="boolean"?C[b]=y:y.isMatrix3?(C[b]=y.elements[0],C[b+1]=y.elements[1],C[b+2]=y.elements[2],C[b+3]=0,C[b+4]=y.elements[3],C[b+5]=y.elements[4],C[b+6]=y.elements[5],C[b+7]=0,C[b+8]=y.elements[6],C[b+9]=y.elements[7],C[b+10]=y.elements[8],C[b+11]=0):ArrayBuffer.isView(y)?C.set(y.subarray(0,C.length-b),b):y.toArray(C,b)}function f(y,C,b,P){let A=y.value,x=C+"_"+b;if(Array.isArray(A)){P[x]===void 0&&(P[x]=[]);let T=P[x],B=!1;for(let D=0;D<A.length;D++)p(A[D],T,D)===!0&&(B=!0);return B}return p(A,P,x)}function p(y,C,b){if(C[b]===void 0)return typeof y=="number"||typeof y=="boolean"?C[b]=y:ArrayBuffer.isView(y)?C[b]=y.slice():C[b]=y.clone(),!0;{let P=C[b];if(typeof y=="number"||typeof y=="boolean"){if(P!==y)return C[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(P.equals(y)===!1)return P.copy(y),!0}}return!1}function g(y){let C=y.uniforms,b=0,P=16;for(let x=0,T=C.length;x<T;x++){let B=Array.isArray(C[x])?C[x]:[C[x]];for(let D=0,I=B.length;D<I;D++){let k=B[D],V=Array.isArray(k.value)?k.value:[k.value],N=Array.isArray(C[x])||Array.isArray(k.value),H=b;for(let G=0,le=V.length;G<le;G++){let J=V[G],j=v(J,N),ie=b%P,fe=ie%j.boundary,ue=ie+fe;b+=fe,ue!==0&&P-ue<j.storage&&(b+=P-ue),G===0&&(H=b),b+=j.storage}let $=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new $((b-H)/Float32Array.BYTES_PER_ELEMENT),k.__offset=H}}let A=b%P;return A>0&&(b+=P-A),y.__size=b,y.__cache={},this}function v(y,C){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",y),C===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function d(y){let C=y.target;C.removeEventListener("dispose",d),n.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function m(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:m}}var F1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ns=null;function O1(){return ns===null&&(ns=new cr(F1,16,16,Bi,Oi),ns.name="DFG_LUT",ns.minFilter=Jn,ns.magFilter=Jn,ns.wrapS=Ji,ns.wrapT=Ji,ns.generateMipmaps=!1,ns.needsUpdate=!0),ns}var du=class{constructor(e={}){let{canvas:t=Em(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:p=zn}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let v=p,d=new Set([Nc,Lc,Ic]),m=new Set([zn,Fi,yo,mr,Rc,Pc]),y=new Uint32Array(4),C=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},P=null,A=null,x=[],T=[],B=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ts,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,I=!1,k=null,V=null,N=null,H=null;this._outputColorSpace=Yn;let $=0,G=0,le=null,J=-1,j=null,ie=new Bt,fe=new Bt,ue=null,Q=new Xe(0),me=0,xe=t.width,Ee=t.height,Me=1,He=null,it=null,Ve=new Bt(0,0,xe,Ee),ct=new Bt(0,0,xe,Ee),ot=!1,tt=new Gs,$t=new rc,Ot=!1,cn=!1,It=new yt,Tn=new W,vt=new Bt,vn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},jt=!1;function un(){return le===null?Me:1}let F=i;function Re(w,O){return t.getContext(w,O)}let $e,st,be,Dt,ze,qe,E,S,X,ce,re,_e,ve,ee,ne,pe,U,se,te,we,ge,Se,Ge;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Oe,!1),t.addEventListener("webglcontextrestored",Ke,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),F===null){let O="webgl2";if(F=Re(O,w),F===null)throw Re(O)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Je()}catch(w){throw t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",Ke,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),je("WebGLRenderer: "+w.message),w}function Je(){$e=new Yb(F),$e.init(),ge=new P1(F,$e),st=new Ob(F,$e,e,ge),be=new C1(F,$e),st.reversedDepthBuffer&&f&&be.buffers.depth.setReversed(!0),V=F.createFramebuffer(),N=F.createFramebuffer(),H=F.createFramebuffer(),Dt=new Kb(F),ze=new p1,qe=new R1(F,$e,be,ze,st,ge,Dt),E=new $b(D),S=new Qy(F),Se=new Ub(F,S),X=new Zb(F,S,Dt,Se),ce=new Qb(F,X,S,Se,Dt),se=new jb(F,st,qe),ne=new Bb(ze),re=new d1(D,E,$e,st,Se,ne),_e=new D1(D,ze),ve=new g1,ee=new M1($e),U=new Db(D,E,be,ce,g,l),pe=new E1(D,ce,st),Ge=new U1(F,Dt,st,be),te=new Fb(F,$e,Dt),we=new Jb(F,$e,Dt),Dt.programs=re.programs,D.capabilities=st,D.extensions=$e,D.properties=ze,D.renderLists=ve,D.shadowMap=pe,D.state=be,D.info=Dt}v!==zn&&(B=new tw(v,t.width,t.height,a,s,r));let ae=new Cf(D,F);this.xr=ae,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let w=$e.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=$e.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Me},this.setPixelRatio=function(w){w!==void 0&&(Me=w,this.setSize(xe,Ee,!1))},this.getSize=function(w){return w.set(xe,Ee)},this.setSize=function(w,O,K=!0){if(ae.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}xe=w,Ee=O,t.width=Math.floor(w*Me),t.height=Math.floor(O*Me),K===!0&&(t.style.width=w+"px",t.style.height=O+"px"),B!==null&&B.setSize(t.width,t.height),this.setViewport(0,0,w,O)},this.getDrawingBufferSize=function(w){return w.set(xe*Me,Ee*Me).floor()},this.setDrawingBufferSize=function(w,O,K){xe=w,Ee=O,Me=K,t.width=Math.floor(w*K),t.height=Math.floor(O*K),this.setViewport(0,0,w,O)},this.setEffects=function(w){if(v===zn){je("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let O=0;O<w.length;O++)if(w[O].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(ie)},this.getViewport=function(w){return w.copy(Ve)},this.setViewport=function(w,O,K,q){w.isVector4?Ve.set(w.x,w.y,w.z,w.w):Ve.set(w,O,K,q),be.viewport(ie.copy(Ve).multiplyScalar(un()).round())},this.getScissor=function(w){return w.copy(ct)},this.setScissor=function(w,O,K,q){w.isVector4?ct.set(w.x,w.y,w.z,w.w):ct.set(w,O,K,q),be.scissor(fe.copy(ct).multiplyScalar(un()).round())},this.getScissorTest=function(){return ot},this.setScissorTest=function(w){be.setScissorTest(ot=w)},this.setOpaqueSort=function(w){He=w},this.setTransparentSort=function(w){it=w},this.getClearColor=function(w){return w.copy(U.getClearColor())},this.setClearColor=function(){U.setClearColor(...arguments)},this.getClearAlpha=function(){return U.getClearAlpha()},this.setClearAlpha=function(){U.setClearAlpha(...arguments)},this.clear=function(w=!0,O=!0,K=!0){let q=0;if(w){let Y=!1;if(le!==null){let Te=le.texture.format;Y=d.has(Te)}if(Y){let Te=le.texture.type,Pe=m.has(Te),Ae=U.getClearColor(),Ie=U.getClearAlpha(),ke=Ae.r,Qe=Ae.g,ht=Ae.b;Pe?(y[0]=ke,y[1]=Qe,y[2]=ht,y[3]=Ie,F.clearBufferuiv(F.COLOR,0,y)):(C[0]=ke,C[1]=Qe,C[2]=ht,C[3]=Ie,F.clearBufferiv(F.COLOR,0,C))}else q|=F.COLOR_BUFFER_BIT}O&&(q|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),K&&(q|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&F.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),k=w},this.dispose=function(){t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",Ke,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),U.dispose(),ve.dispose(),ee.dispose(),qe.dispose(),ze.dispose(),E.dispose(),ce.dispose(),X.dispose(),Se.dispose(),Ge.dispose(),re.dispose(),ae.dispose(),ae.removeEventListener("sessionstart",gl),ae.removeEventListener("sessionend",Gi),os.stop()};function Oe(w){w.preventDefault(),df("WebGLRenderer: Context Lost."),I=!0}function Ke(){df("WebGLRenderer: Context Restored."),I=!1;let w=Dt.autoReset,O=pe.enabled,K=pe.autoUpdate,q=pe.needsUpdate,Y=pe.type;Je(),Dt.autoReset=w,pe.enabled=O,pe.autoUpdate=K,pe.needsUpdate=q,pe.type=Y}function Ce(w){je("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function rt(w){let O=w.target;O.removeEventListener("dispose",rt),zt(O)}function zt(w){Hn(w),ze.remove(w)}function Hn(w){let O=ze.get(w).programs;O!==void 0&&(O.forEach(function(K){re.releaseProgram(K)}),w.isShaderMaterial&&re.releaseShaderCache(w))}this.renderBufferDirect=function(w,O,K,q,Y,Te){O===null&&(O=vn);let Pe=Y.isMesh&&Y.matrixWorld.determinantAffine()<0,Ae=$o(w,O,K,q,Y);be.setMaterial(q,Pe);let Ie=K.index,ke=1;if(q.wireframe===!0){if(Ie=X.getWireframeAttribute(K),Ie===void 0)return;ke=2}let Qe=K.drawRange,ht=K.attributes.position,Be=Qe.start*ke,ft=(Qe.start+Qe.count)*ke;Te!==null&&(Be=Math.max(Be,Te.start*ke),ft=Math.min(ft,(Te.start+Te.count)*ke)),Ie!==null?(Be=Math.max(Be,0),ft=Math.min(ft,Ie.count)):ht!=null&&(Be=Math.max(Be,0),ft=Math.min(ft,ht.count));let Jt=ft-Be;if(Jt<0||Jt===1/0)return;Se.setup(Y,q,Ae,K,Ie);let Ct,Rt=te;if(Ie!==null&&(Ct=S.get(Ie),Rt=we,Rt.setIndex(Ct)),Y.isMesh)q.wireframe===!0?(be.setLineWidth(q.wireframeLinewidth*un()),Rt.setMode(F.LINES)):Rt.setMode(F.TRIANGLES);else if(Y.isLine){let yn=q.linewidth;yn===void 0&&(yn=1),be.setLineWidth(yn*un()),Y.isLineSegments?Rt.setMode(F.LINES):Y.isLineLoop?Rt.setMode(F.LINE_LOOP):Rt.setMode(F.LINE_STRIP)}else Y.isPoints?Rt.setMode(F.POINTS):Y.isSprite&&Rt.setMode(F.TRIANGLES);if(Y.isBatchedMesh)if($e.get("WEBGL_multi_draw"))Rt.renderMultiDraw(Y._multiDrawStarts,Y._multiDrawCounts,Y._multiDrawCount);else{let yn=Y._multiDrawStarts,Ue=Y._multiDrawCounts,hn=Y._multiDrawCount,mt=Ie?S.get(Ie).bytesPerElement:1,ls=ze.get(q).currentProgram.getUniforms();for(let fn=0;fn<hn;fn++)ls.setValue(F,"_gl_DrawID",fn),Rt.render(yn[fn]/mt,Ue[fn])}else if(Y.isInstancedMesh)Rt.renderInstances(Be,Jt,Y.count);else if(K.isInstancedBufferGeometry){let yn=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,Ue=Math.min(K.instanceCount,yn);Rt.renderInstances(Be,Jt,Ue)}else Rt.render(Be,Jt)};function Wo(w,O,K,q){k!==null&&w.isNodeMaterial&&k.setObject(q,w),Ot===!0&&ne.setState(w,K,!1),w.transparent===!0&&w.side===es&&w.forceSinglePass===!1?(w.side=Kn,w.needsUpdate=!0,Hi(w,O,q),w.side=$s,w.needsUpdate=!0,Hi(w,O,q),w.side=es):Hi(w,O,q)}this.compile=function(w,O,K=null){K===null&&(K=w),k!==null&&k.renderStart(w,O,K),A=ee.get(K),A.init(O),T.push(A),K.traverseVisible(function(Y){Y.isLight&&Y.layers.test(O.layers)&&(A.pushLight(Y),Y.castShadow&&A.pushShadow(Y))}),w!==K&&w.traverseVisible(function(Y){Y.isLight&&Y.layers.test(O.layers)&&(A.pushLight(Y),Y.castShadow&&A.pushShadow(Y))}),A.setupLights(),k!==null&&k.updateLights(A.state.lightsArray),cn=this.localClippingEnabled,Ot=ne.init(this.clippingPlanes,cn),Ot===!0&&ne.setGlobalState(this.clippingPlanes,O),k!==null&&pe.render(A.state.shadowsArray,K,O);let q=new Set;return w.traverse(function(Y){if(!(Y.isMesh||Y.isPoints||Y.isLine||Y.isSprite))return;let Te=Y.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let Ae=Te[Pe];Wo(Ae,K,O,Y),q.add(Ae)}else Wo(Te,K,O,Y),q.add(Te)}),A=T.pop(),k!==null&&k.renderEnd(),q},this.compileAsync=function(w,O,K=null){let q=this.compile(w,O,K);return new Promise(Y=>{function Te(){if(q.forEach(function(Pe){let Ie=ze.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&q.delete(Pe)}),q.size===0){Y(w);return}setTimeout(Te,10)}$e.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let Lr=null;function nh(w){Lr&&Lr(w)}function gl(){os.stop()}function Gi(){os.start()}let os=new ig;os.setAnimationLoop(nh),typeof self<"u"&&os.setContext(self),this.setAnimationLoop=function(w){Lr=w,ae.setAnimationLoop(w),w===null?os.stop():os.start()},ae.addEventListener("sessionstart",gl),ae.addEventListener("sessionend",Gi),this.render=function(w,O){if(O!==void 0&&O.isCamera!==!0){je("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;k!==null&&k.renderStart(w,O);let K=ae.enabled===!0&&ae.isPresenting===!0,q=B!==null&&(le===null||K)&&B.begin(D,le);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),O.parent===null&&O.matrixWorldAutoUpdate===!0&&O.updateMatrixWorld(),ae.enabled===!0&&ae.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(ae.cameraAutoUpdate===!0&&ae.updateCamera(O),O=ae.getCamera()),w.isScene===!0&&w.onBeforeRender(D,w,O,le),A=ee.get(w,T.length),A.init(O),A.state.textureUnits=qe.getTextureUnits(),T.push(A),It.multiplyMatrices(O.projectionMatrix,O.matrixWorldInverse),O.isArrayCamera?$t.setFromArrayCamera(O):tt.setFromProjectionMatrix(It,yi,O.reversedDepth),cn=this.localClippingEnabled,Ot=ne.init(this.clippingPlanes,cn),P=ve.get(w,x.length),P.init(),x.push(P),this.info.render.frame++,ae.enabled===!0&&ae.isPresenting===!0){let Pe=D.xr.getDepthSensingMesh();Pe!==null&&as(Pe,O,-1/0,D.sortObjects)}as(w,O,0,D.sortObjects),P.finish(),k!==null&&k.updateLights(A.state.lightsArray),D.sortObjects===!0&&P.sort(He,it),jt=ae.enabled===!1||ae.isPresenting===!1||ae.hasDepthSensing()===!1,jt&&U.addToRenderList(P,w),this.info.autoReset===!0&&this.info.reset(),Ot===!0&&ne.beginShadows();let Y=A.state.shadowsArray;if(pe.render(Y,w,O),Ot===!0&&ne.endShadows(),(q&&B.hasRenderPass())===!1){let Pe=P.opaque,Ae=P.transmissive;if(A.setupLights(),O.isArrayCamera){let Ie=O.cameras;if(Ae.length>0)for(let ke=0,Qe=Ie.length;ke<Qe;ke++){let ht=Ie[ke];Ei(Pe,Ae,w,ht)}jt&&U.render(w);for(let ke=0,Qe=Ie.length;ke<Qe;ke++){let ht=Ie[ke];Xo(P,w,ht,ht.viewport)}}else Ae.length>0&&Ei(Pe,Ae,w,O),jt&&U.render(w),Xo(P,w,O)}le!==null&&G===0&&(qe.updateMultisampleRenderTarget(le),qe.updateRenderTargetMipmap(le)),q&&B.end(D),w.isScene===!0&&w.onAfterRender(D,w,O),Se.resetDefaultState(),J=-1,j=null,T.pop(),T.length>0?(A=T[T.length-1],qe.setTextureUnits(A.state.textureUnits),Ot===!0&&ne.setGlobalState(D.clippingPlanes,A.state.camera)):A=null,x.pop(),x.length>0?P=x[x.length-1]:P=null,k!==null&&k.renderEnd()};function as(w,O,K,q){if(w.visible===!1)return;if(w.layers.test(O.layers)){if(w.isGroup)K=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(O);else if(w.isLight)A.pushLight(w),w.castShadow&&A.pushShadow(w);else if(w.isSprite){let Pe=O.isArrayCamera?$t:tt;if(!w.frustumCulled||w.intersectsFrustum(Pe)){q&&vt.setFromMatrixPosition(w.matrixWorld).applyMatrix4(It);let Ae=ce.update(w),Ie=w.material;Ie.visible&&P.push(w,Ae,Ie,K,vt.z,null,O)}}else if(w.isMesh||w.isLine||w.isPoints){let Pe=O.isArrayCamera?$t:tt;if(!w.frustumCulled||w.intersectsFrustum(Pe)){let Ae=ce.update(w),Ie=w.material;if(q&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),vt.copy(w.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),vt.copy(Ae.boundingSphere.center)),vt.applyMatrix4(w.matrixWorld).applyMatrix4(It)),Array.isArray(Ie)){let ke=Ae.groups;for(let Qe=0,ht=ke.length;Qe<ht;Qe++){let Be=ke[Qe],ft=Ie[Be.materialIndex];ft&&ft.visible&&P.push(w,Ae,ft,K,vt.z,Be,O)}}else Ie.visible&&P.push(w,Ae,Ie,K,vt.z,null,O)}}}let Te=w.children;for(let Pe=0,Ae=Te.length;Pe<Ae;Pe++)as(Te[Pe],O,K,q)}function Xo(w,O,K,q){let{opaque:Y,transmissive:Te,transparent:Pe}=w;A.setupLightsView(K),Ot===!0&&ne.setGlobalState(D.clippingPlanes,K),q&&be.viewport(ie.copy(q)),Y.length>0&&Qt(Y,O,K),Te.length>0&&Qt(Te,O,K),Pe.length>0&&Qt(Pe,O,K),be.buffers.depth.setTest(!0),be.buffers.depth.setMask(!0),be.buffers.color.setMask(!0),be.setPolygonOffset(!1)}function Ei(w,O,K,q){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[q.id]===void 0){let Be=$e.has("EXT_color_buffer_half_float")||$e.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[q.id]=new ui(1,1,{generateMipmaps:!0,type:Be?Oi:zn,minFilter:Ss,samples:Math.max(4,st.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:gt.workingColorSpace})}let Te=A.state.transmissionRenderTarget[q.id],Pe=q.viewport||ie;Te.setSize(Pe.z*D.transmissionResolutionScale,Pe.w*D.transmissionResolutionScale);let Ae=D.getRenderTarget(),Ie=D.getActiveCubeFace(),ke=D.getActiveMipmapLevel();D.setRenderTarget(Te),D.getClearColor(Q),me=D.getClearAlpha(),me<1&&D.setClearColor(16777215,.5),D.clear(),jt&&U.render(K);let Qe=D.toneMapping;D.toneMapping=ts;let ht=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),A.setupLightsView(q),Ot===!0&&ne.setGlobalState(D.clippingPlanes,q),Qt(w,K,q),qe.updateMultisampleRenderTarget(Te),qe.updateRenderTargetMipmap(Te),$e.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let ft=0,Jt=O.length;ft<Jt;ft++){let Ct=O[ft],{object:Rt,geometry:yn,material:Ue,group:hn}=Ct;if(Ue.side===es&&Rt.layers.test(q.layers)){let mt=Ue.side;Ue.side=Kn,Ue.needsUpdate=!0,on(Rt,K,q,yn,Ue,hn),Ue.side=mt,Ue.needsUpdate=!0,Be=!0}}Be===!0&&(qe.updateMultisampleRenderTarget(Te),qe.updateRenderTargetMipmap(Te))}D.setRenderTarget(Ae,Ie,ke),D.setClearColor(Q,me),ht!==void 0&&(q.viewport=ht),D.toneMapping=Qe}function Qt(w,O,K){let q=O.isScene===!0?O.overrideMaterial:null;for(let Y=0,Te=w.length;Y<Te;Y++){let Pe=w[Y],{object:Ae,geometry:Ie,group:ke}=Pe,Qe=Pe.material;Qe.allowOverride===!0&&q!==null&&(Qe=q),Ae.layers.test(K.layers)&&on(Ae,O,K,Ie,Qe,ke)}}function on(w,O,K,q,Y,Te){k!==null&&Y.isNodeMaterial&&k.setObject(w,Y),w.onBeforeRender(D,O,K,q,Y,Te),w.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),Y.onBeforeRender(D,O,K,q,w,Te),Y.transparent===!0&&Y.side===es&&Y.forceSinglePass===!1?(Y.side=Kn,Y.needsUpdate=!0,D.renderBufferDirect(K,O,q,Y,w,Te),Y.side=$s,Y.needsUpdate=!0,D.renderBufferDirect(K,O,q,Y,w,Te),Y.side=es):D.renderBufferDirect(K,O,q,Y,w,Te),w.onAfterRender(D,O,K,q,Y,Te)}function an(w){let O=0;for(let K of w)K.texture!==null&&O++;return O}function Hi(w,O,K){O.isScene!==!0&&(O=vn);let q=ze.get(w),Y=A.state.lights,Te=A.state.shadowsArray,Pe=Y.state.version,Ae=re.getParameters(w,Y.state,Te,O,K,A.state.lightProbeGridArray),Ie=re.getProgramCacheKey(Ae),ke=q.programs;q.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?O.environment:null,q.fog=O.fog;let Qe=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;q.envMap=E.get(w.envMap||q.environment,Qe),q.envMapRotation=q.environment!==null&&w.envMap===null?O.environmentRotation:w.envMapRotation,ke===void 0&&(w.addEventListener("dispose",rt),ke=new Map,q.programs=ke,q.programVariants=new Map);let ht=ke.get(Ie);if(ht!==void 0){if(q.currentProgram===ht&&q.lightsStateVersion===Pe)return qo(w,Ae),ht}else Ae.uniforms=re.getUniforms(w),k!==null&&w.isNodeMaterial&&k.build(w,K,Ae),w.onBeforeCompile(Ae,D),ht=re.acquireProgram(Ae,Ie),ke.set(Ie,ht),q.uniforms=Ae.uniforms;let Be=q.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Be.clippingPlanes=ne.uniform),qo(w,Ae),q.needsLights=Ps(w),q.lightsStateVersion=Pe,q.needsLights&&(Be.ambientLightColor.value=Y.state.ambient,Be.lightProbe.value=Y.state.probe,Be.sunLights.value=Y.state.sun,Be.sunLightShadows.value=Y.state.sunShadow,Be.directionalLights.value=Y.state.directional,Be.directionalLightShadows.value=Y.state.directionalShadow,Be.spotLights.value=Y.state.spot,Be.spotLightShadows.value=Y.state.spotShadow,Be.rectAreaLights.value=Y.state.rectArea,Be.ltc_1.value=Y.state.rectAreaLTC1,Be.ltc_2.value=Y.state.rectAreaLTC2,Be.pointLights.value=Y.state.point,Be.pointLightShadows.value=Y.state.pointShadow,Be.hemisphereLights.value=Y.state.hemi,Be.sunShadowMatrix.value=Y.state.sunShadowMatrix,Be.sunShadowCascade.value=Y.state.sunShadowCascade,Be.directionalShadowMatrix.value=Y.state.directionalShadowMatrix,Be.spotLightMatrix.value=Y.state.spotLightMatrix,Be.spotLightMap.value=Y.state.spotLightMap,Be.pointShadowMatrix.value=Y.state.pointShadowMatrix),q.numLightProbeGrids=an(A.state.lightProbeGridArray),q.currentProgram=ht,q.uniformsList=null,ht}function si(w,O,K,q,Y){let Te=ze.get(w),Pe=Te.currentProgram.id+","+q+","+Y,Ae=Te.programVariants.get(Pe);return Ae===void 0?(Ae=Hi(w,O,K),Te.programVariants.set(Pe,Ae)):(Te.currentProgram=Ae,Te.uniformsList=null,Te.outputColorSpace=q,Te.toneMapping=Y),Ae}function Rs(w){if(w.uniformsList===null){let O=w.currentProgram.getUniforms();w.uniformsList=Mo.seqWithValue(O.seq,w.uniforms)}return w.uniformsList}function qo(w,O){let K=ze.get(w);K.outputColorSpace=O.outputColorSpace,K.batching=O.batching,K.batchingColor=O.batchingColor,K.instancing=O.instancing,K.instancingColor=O.instancingColor,K.instancingMorph=O.instancingMorph,K.skinning=O.skinning,K.morphTargets=O.morphTargets,K.morphNormals=O.morphNormals,K.morphColors=O.morphColors,K.morphTargetsCount=O.morphTargetsCount,K.numClippingPlanes=O.numClippingPlanes,K.numIntersection=O.numClipIntersection,K.vertexAlphas=O.vertexAlphas,K.vertexTangents=O.vertexTangents,K.toneMapping=O.toneMapping}function $o(w,O,K,q,Y){O.isScene!==!0&&(O=vn),qe.resetTextureUnits();let Te=O.fog,Pe=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?O.environment:null,Ae=le===null?D.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:gt.workingColorSpace,Ie=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,ke=E.get(q.envMap||Pe,Ie),Qe=q.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,ht=!!K.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),Be=!!K.morphAttributes.position,ft=!!K.morphAttributes.normal,Jt=!!K.morphAttributes.color,Ct=ts;q.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Ct=D.toneMapping);let Rt=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,yn=Rt!==void 0?Rt.length:0,Ue=ze.get(q),hn=A.state.lights;if(Ot===!0&&(cn===!0||w!==j)){let Pt=w===j&&q.id===J;ne.setState(q,w,Pt)}let mt=!1,ls=!1;q.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==hn.state.version||Y.isBatchedMesh&&Ue.batching===!1||!Y.isBatchedMesh&&Ue.batching===!0||Y.isBatchedMesh&&Ue.batchingColor===!0&&Y._colorsTexture===null||Y.isBatchedMesh&&Ue.batchingColor===!1&&Y._colorsTexture!==null||Y.isInstancedMesh&&Ue.instancing===!1||!Y.isInstancedMesh&&Ue.instancing===!0||Y.isSkinnedMesh&&Ue.skinning===!1||!Y.isSkinnedMesh&&Ue.skinning===!0||Y.isInstancedMesh&&Ue.instancingColor===!0&&Y.instanceColor===null||Y.isInstancedMesh&&Ue.instancingColor===!1&&Y.instanceColor!==null||Y.isInstancedMesh&&Ue.instancingMorph===!0&&Y.morphTexture===null||Y.isInstancedMesh&&Ue.instancingMorph===!1&&Y.morphTexture!==null||Ue.envMap!==ke||q.fog===!0&&Ue.fog!==Te||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==ne.numPlanes||Ue.numIntersection!==ne.numIntersection)||Ue.vertexAlphas!==Qe||Ue.vertexTangents!==ht||Ue.morphTargets!==Be||Ue.morphNormals!==ft||Ue.morphColors!==Jt||Ue.morphTargetsCount!==yn||Ue.numLightProbeGrids!==an(A.state.lightProbeGridArray)?mt=!0:(Ue.outputColorSpace!==Ae||Ue.toneMapping!==Ct)&&(ls=!0):(mt=!0,Ue.__version=q.version);let fn=Ue.currentProgram;(mt===!0||ls===!0)&&(fn=ls===!0?si(q,O,Y,Ae,Ct):Hi(q,O,Y),k&&q.isNodeMaterial&&k.onUpdateProgram(q,fn,Ue));let Ur=!1,Wi=!1,cs=!1,at=fn.getUniforms(),en=Ue.uniforms;if(be.useProgram(fn.program)&&(Ur=!0,Wi=!0,cs=!0),q.id!==J&&(J=q.id,Wi=!0),Ur||j!==w){be.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),at.setValue(F,"projectionMatrix",w.projectionMatrix),at.setValue(F,"viewMatrix",w.matrixWorldInverse);let dn=at.map.cameraPosition;dn!==void 0&&dn.setValue(F,Tn.setFromMatrixPosition(w.matrixWorld)),st.logarithmicDepthBuffer&&at.setValue(F,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&at.setValue(F,"isOrthographic",w.isOrthographicCamera===!0),j!==w&&(j=w,Wi=!0,cs=!0)}if(Ue.needsLights&&(hn.state.sunShadowMap.length>0&&at.setValue(F,"sunShadowMap",hn.state.sunShadowMap,qe),hn.state.directionalShadowMap.length>0&&at.setValue(F,"directionalShadowMap",hn.state.directionalShadowMap,qe),hn.state.spotShadowMap.length>0&&at.setValue(F,"spotShadowMap",hn.state.spotShadowMap,qe),hn.state.pointShadowMap.length>0&&at.setValue(F,"pointShadowMap",hn.state.pointShadowMap,qe)),Y.isSkinnedMesh){at.setOptional(F,Y,"bindMatrix"),at.setOptional(F,Y,"bindMatrixInverse");let Pt=Y.skeleton;Pt&&(Pt.boneTexture===null&&Pt.computeBoneTexture(),at.setValue(F,"boneTexture",Pt.boneTexture,qe))}Y.isBatchedMesh&&(at.setOptional(F,Y,"batchingTexture"),at.setValue(F,"batchingTexture",Y._matricesTexture,qe),at.setOptional(F,Y,"batchingIdTexture"),at.setValue(F,"batchingIdTexture",Y._indirectTexture,qe),at.setOptional(F,Y,"batchingColorTexture"),Y._colorsTexture!==null&&at.setValue(F,"batchingColorTexture",Y._colorsTexture,qe));let Wn=K.morphAttributes;if((Wn.position!==void 0||Wn.normal!==void 0||Wn.color!==void 0)&&se.update(Y,K,fn),(Wi||Ue.receiveShadow!==Y.receiveShadow)&&(Ue.receiveShadow=Y.receiveShadow,at.setValue(F,"receiveShadow",Y.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&O.environment!==null&&(en.envMapIntensity.value=O.environmentIntensity),en.dfgLUT!==void 0&&(en.dfgLUT.value=O1()),Wi){if(at.setValue(F,"toneMappingExposure",D.toneMappingExposure),Ue.needsLights&&Nr(en,cs),Te&&q.fog===!0&&_e.refreshFogUniforms(en,Te),_e.refreshMaterialUniforms(en,q,Me,Ee,A.state.transmissionRenderTarget[w.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let Pt=b,dn=0;for(let On of A.state.lightProbeGridArray)On.texture!==null&&(Pt.textures[dn]=On.texture,Pt.min[dn]=On.boundingBox.min,Pt.max[dn]=On.boundingBox.max,Pt.resolution[dn]=On.resolution,dn++);for(let On in Pt)Pt[On].length=dn;en.probesSH.value=Pt.textures,en.probesMin.value=Pt.min,en.probesMax.value=Pt.max,en.probesResolution.value=Pt.resolution}Mo.upload(F,Rs(Ue),en,qe)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(Mo.upload(F,Rs(Ue),en,qe),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&at.setValue(F,"center",Y.center),at.setValue(F,"modelViewMatrix",Y.modelViewMatrix),at.setValue(F,"normalMatrix",Y.normalMatrix),at.setValue(F,"modelMatrix",Y.matrixWorld),q.uniformsGroups!==void 0){let Pt=q.uniformsGroups;for(let dn=0,On=Pt.length;dn<On;dn++){let _l=Pt[dn];Ge.update(_l,fn),Ge.bind(_l,fn)}}return fn}function Nr(w,O){w.ambientLightColor.needsUpdate=O,w.lightProbe.needsUpdate=O,w.sunLights.needsUpdate=O,w.sunLightShadows.needsUpdate=O,w.directionalLights.needsUpdate=O,w.directionalLightShadows.needsUpdate=O,w.pointLights.needsUpdate=O,w.pointLightShadows.needsUpdate=O,w.spotLights.needsUpdate=O,w.spotLightShadows.needsUpdate=O,w.rectAreaLights.needsUpdate=O,w.hemisphereLights.needsUpdate=O}function Ps(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(w,O,K){let q=ze.get(w);q.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),ze.get(w.texture).__webglTexture=O,ze.get(w.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:K,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,O){let K=ze.get(w);K.__webglFramebuffer=O,K.__useDefaultFramebuffer=O===void 0},this.setRenderTarget=function(w,O=0,K=0){le=w,$=O,G=K;let q=null,Y=!1,Te=!1;if(w){let Ae=ze.get(w);if(Ae.__useDefaultFramebuffer!==void 0){be.bindFramebuffer(F.FRAMEBUFFER,Ae.__webglFramebuffer),ie.copy(w.viewport),fe.copy(w.scissor),ue=w.scissorTest,be.viewport(ie),be.scissor(fe),be.setScissorTest(ue),J=-1;return}else if(Ae.__webglFramebuffer===void 0)qe.setupRenderTarget(w);else if(Ae.__hasExternalTextures)qe.rebindTextures(w,ze.get(w.texture).__webglTexture,ze.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let Qe=w.depthTexture;if(Ae.__boundDepthTexture!==Qe){if(Qe!==null&&ze.has(Qe)&&(w.width!==Qe.image.width||w.height!==Qe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qe.setupDepthRenderbuffer(w)}}let Ie=w.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Te=!0);let ke=ze.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(ke[O])?q=ke[O][K]:q=ke[O],Y=!0):w.samples>0&&qe.useMultisampledRTT(w)===!1?q=ze.get(w).__webglMultisampledFramebuffer:Array.isArray(ke)?q=ke[K]:q=ke,ie.copy(w.viewport),fe.copy(w.scissor),ue=w.scissorTest}else ie.copy(Ve).multiplyScalar(Me).floor(),fe.copy(ct).multiplyScalar(Me).floor(),ue=ot;if(K!==0&&(q=V),be.bindFramebuffer(F.FRAMEBUFFER,q)&&be.drawBuffers(w,q),be.viewport(ie),be.scissor(fe),be.setScissorTest(ue),Y){let Ae=ze.get(w.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+O,Ae.__webglTexture,K)}else if(Te){let Ae=O;for(let Ie=0;Ie<w.textures.length;Ie++){let ke=ze.get(w.textures[Ie]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+Ie,ke.__webglTexture,K,Ae)}}else if(w!==null&&K!==0){let Ae=ze.get(w.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ae.__webglTexture,K)}J=-1};function Dr(w){let O=ze.get(w);return(O.__readFormat!==w.format||O.__readType!==w.type)&&(O.__readFormat=w.format,O.__readType=w.type,O.__formatReadable=st.textureFormatReadable(w.format),O.__typeReadable=st.textureTypeReadable(w.type)),O}this.readRenderTargetPixels=function(w,O,K,q,Y,Te,Pe,Ae=0){if(!(w&&w.isWebGLRenderTarget)){je("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=ze.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){be.bindFramebuffer(F.FRAMEBUFFER,Ie);try{let ke=w.textures[Ae],Qe=ke.format,ht=ke.type;w.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ae);let Be=Dr(ke);if(Be.__formatReadable===!1){je("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){je("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}O>=0&&O<=w.width-q&&K>=0&&K<=w.height-Y&&F.readPixels(O,K,q,Y,ge.convert(Qe),ge.convert(ht),Te)}finally{let ke=le!==null?ze.get(le).__webglFramebuffer:null;be.bindFramebuffer(F.FRAMEBUFFER,ke)}}},this.readRenderTargetPixelsAsync=async function(w,O,K,q,Y,Te,Pe,Ae=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=ze.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(O>=0&&O<=w.width-q&&K>=0&&K<=w.height-Y){be.bindFramebuffer(F.FRAMEBUFFER,Ie);let ke=w.textures[Ae],Qe=ke.format,ht=ke.type;w.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ae);let Be=Dr(ke);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ft=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,ft),F.bufferData(F.PIXEL_PACK_BUFFER,Te.byteLength,F.STREAM_READ),F.readPixels(O,K,q,Y,ge.convert(Qe),ge.convert(ht),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let Jt=le!==null?ze.get(le).__webglFramebuffer:null;be.bindFramebuffer(F.FRAMEBUFFER,Jt);let Ct=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await Rm(F,Ct,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,ft),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,Te),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(ft),F.deleteSync(Ct),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,O=null,K=0){let q=Math.pow(2,-K),Y=Math.floor(w.image.width*q),Te=Math.floor(w.image.height*q),Pe=O!==null?O.x:0,Ae=O!==null?O.y:0;qe.setTexture2D(w,0),F.copyTexSubImage2D(F.TEXTURE_2D,K,0,0,Pe,Ae,Y,Te),be.unbindTexture()},this.copyTextureToTexture=function(w,O,K=null,q=null,Y=0,Te=0){let Pe,Ae,Ie,ke,Qe,ht,Be,ft,Jt,Ct=w.isCompressedTexture?w.mipmaps[Te]:w.image;if(K!==null)Pe=K.max.x-K.min.x,Ae=K.max.y-K.min.y,Ie=K.isBox3?K.max.z-K.min.z:1,ke=K.min.x,Qe=K.min.y,ht=K.isBox3?K.min.z:0;else{let at=Math.pow(2,-Y);Pe=Math.floor(Ct.width*at),Ae=Math.floor(Ct.height*at),w.isDataArrayTexture?Ie=Ct.depth:w.isData3DTexture?Ie=Math.floor(Ct.depth*at):Ie=1,ke=0,Qe=0,ht=0}q!==null?(Be=q.x,ft=q.y,Jt=q.z):(Be=0,ft=0,Jt=0);let Rt=ge.convert(O.format),yn=ge.convert(O.type),Ue;O.isData3DTexture?(qe.setTexture3D(O,0),Ue=F.TEXTURE_3D):O.isDataArrayTexture||O.isCompressedArrayTexture?(qe.setTexture2DArray(O,0),Ue=F.TEXTURE_2D_ARRAY):(qe.setTexture2D(O,0),Ue=F.TEXTURE_2D),be.activeTexture(F.TEXTURE0),be.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,O.flipY),be.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,O.premultiplyAlpha),be.pixelStorei(F.UNPACK_ALIGNMENT,O.unpackAlignment);let hn=be.getParameter(F.UNPACK_ROW_LENGTH),mt=be.getParameter(F.UNPACK_IMAGE_HEIGHT),ls=be.getParameter(F.UNPACK_SKIP_PIXELS),fn=be.getParameter(F.UNPACK_SKIP_ROWS),Ur=be.getParameter(F.UNPACK_SKIP_IMAGES);be.pixelStorei(F.UNPACK_ROW_LENGTH,Ct.width),be.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Ct.height),be.pixelStorei(F.UNPACK_SKIP_PIXELS,ke),be.pixelStorei(F.UNPACK_SKIP_ROWS,Qe),be.pixelStorei(F.UNPACK_SKIP_IMAGES,ht);let Wi=w.isDataArrayTexture||w.isData3DTexture,cs=O.isDataArrayTexture||O.isData3DTexture;if(w.isDepthTexture){let at=ze.get(w),en=ze.get(O),Wn=ze.get(at.__renderTarget),Pt=ze.get(en.__renderTarget);be.bindFramebuffer(F.READ_FRAMEBUFFER,Wn.__webglFramebuffer),be.bindFramebuffer(F.DRAW_FRAMEBUFFER,Pt.__webglFramebuffer);for(let dn=0;dn<Ie;dn++)Wi&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ze.get(w).__webglTexture,Y,ht+dn),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ze.get(O).__webglTexture,Te,Jt+dn)),F.blitFramebuffer(ke,Qe,ke+Pe,Qe+Ae,Be,ft,Be+Pe,ft+Ae,F.DEPTH_BUFFER_BIT,F.NEAREST);be.bindFramebuffer(F.READ_FRAMEBUFFER,null),be.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(Y!==0||w.isRenderTargetTexture||ze.has(w)){let at=ze.get(w),en=ze.get(O);be.bindFramebuffer(F.READ_FRAMEBUFFER,N),be.bindFramebuffer(F.DRAW_FRAMEBUFFER,H);for(let Wn=0;Wn<Ie;Wn++)Wi?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,at.__webglTexture,Y,ht+Wn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,at.__webglTexture,Y),cs?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,en.__webglTexture,Te,Jt+Wn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,en.__webglTexture,Te),Y!==0?F.blitFramebuffer(ke,Qe,ke+Pe,Qe+Ae,Be,ft,Be+Pe,ft+Ae,F.COLOR_BUFFER_BIT,F.NEAREST):cs?F.copyTexSubImage3D(Ue,Te,Be,ft,Jt+Wn,ke,Qe,Pe,Ae):F.copyTexSubImage2D(Ue,Te,Be,ft,ke,Qe,Pe,Ae);be.bindFramebuffer(F.READ_FRAMEBUFFER,null),be.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else cs?w.isDataTexture||w.isData3DTexture?F.texSubImage3D(Ue,Te,Be,ft,Jt,Pe,Ae,Ie,Rt,yn,Ct.data):O.isCompressedArrayTexture?F.compressedTexSubImage3D(Ue,Te,Be,ft,Jt,Pe,Ae,Ie,Rt,Ct.data):F.texSubImage3D(Ue,Te,Be,ft,Jt,Pe,Ae,Ie,Rt,yn,Ct):w.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,Te,Be,ft,Pe,Ae,Rt,yn,Ct.data):w.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,Te,Be,ft,Ct.width,Ct.height,Rt,Ct.data):F.texSubImage2D(F.TEXTURE_2D,Te,Be,ft,Pe,Ae,Rt,yn,Ct);be.pixelStorei(F.UNPACK_ROW_LENGTH,hn),be.pixelStorei(F.UNPACK_IMAGE_HEIGHT,mt),be.pixelStorei(F.UNPACK_SKIP_PIXELS,ls),be.pixelStorei(F.UNPACK_SKIP_ROWS,fn),be.pixelStorei(F.UNPACK_SKIP_IMAGES,Ur),Te===0&&O.generateMipmaps===!0&&O.mipmapsAutoUpdate===!0&&F.generateMipmap(Ue),be.unbindTexture()},this.initRenderTarget=function(w){ze.get(w).__webglFramebuffer===void 0&&qe.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?qe.setTextureCube(w,0):w.isData3DTexture?qe.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?qe.setTexture2DArray(w,0):qe.setTexture2D(w,0),be.unbindTexture()},this.resetState=function(){$=0,G=0,le=null,be.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return yi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=gt._getDrawingBufferColorSpace(e),t.unpackColorSpace=gt._getUnpackColorSpace()}};function pg(){let n={camera:new Zn(30,1,.01,100),target:new W,home:null,azimuth:.75,elevation:.4,distance:4.2,changed:!0};return n.home={azimuth:n.azimuth,elevation:n.elevation,distance:n.distance},Ys(n),n}function Ys(n){let e=n.distance*Math.cos(n.elevation);n.camera.up.set(0,0,1),n.camera.position.set(n.target.x+e*Math.cos(n.azimuth),n.target.y+e*Math.sin(n.azimuth),n.target.z+n.distance*Math.sin(n.elevation)),n.camera.lookAt(n.target),n.camera.updateMatrixWorld(),n.changed=!0}function Rf(n,e,t){n.azimuth-=.006*e,n.elevation=Math.max(-1.5,Math.min(1.5,n.elevation+.006*t)),Ys(n)}function mg(n,[e,t,i]){n.azimuth=e===0&&t===0?-Math.PI/2:Math.atan2(t,e),n.elevation=Math.max(-1.5,Math.min(1.5,Math.atan2(i,Math.hypot(e,t)))),Ys(n)}function wo(n,e){n.distance=Math.max(.3,Math.min(30,n.distance*e)),Ys(n)}function Pf(n,e,t,i){let{right:s,up:r}=_r(n),o=Wa(n,n.distance,i);n.target.addScaledVector(s,-e*o).addScaledVector(r,t*o),Ys(n)}function gu(n){Object.assign(n,n.home),n.target.set(0,0,0),Ys(n)}function _r(n){let e=new W,t=new W,i=new W;return n.camera.matrixWorld.extractBasis(e,t,i),{right:e,up:t,forward:i.negate()}}function Wa(n,e,t){return 2*Math.tan(n.camera.fov*Math.PI/360)*e/Math.max(1,t)}function Xa(n,e){let{forward:t}=_r(n);return Math.max(.05,e.clone().sub(n.camera.position).dot(t))}var B1={pause:"M8 5v14M16 5v14",play:"M8 5l11 7-11 7z",step:"M6 5l8 7-8 7zM18 5v14",reset:"M5 12a7 7 0 1 0 2.3-5.2M5 4v4.5h4.5",record:"M12 12m-5.5 0a5.5 5.5 0 1 0 11 0a5.5 5.5 0 1 0-11 0",stop:"M7 7h10v10H7z",theme:"M12 4a8 8 0 1 0 0 16zM12 4a8 8 0 0 1 0 16",help:"M9 9a3 3 0 1 1 4.2 2.75c-.8.4-1.2 1-1.2 2.25M12 17.5v.5",fit:"M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",levels:"M12 4l8 14H4zM8 11h8M12 4v14",ghost:"M6 20V10a6 6 0 0 1 12 0v10l-3-2-3 2-3-2zM10 10v.5M14 10v.5",contacts:"M4 16h16M8 16v-6M16 16v-6M6 12l2-2.5 2 2.5M14 12l2-2.5 2 2.5",forces:"M5 19L19 5M19 5h-7M19 5v7",sound:"M4 10v4h3l5 4V6l-5 4zM15.5 9a4 4 0 0 1 0 6M18 6.5a8 8 0 0 1 0 11",names:"M4 5h9l7 7-7 7H4zM8 12h.5",open:"M3 18V6h6l2 2.5h10V18z",save:"M12 4v11M7 11l5 5 5-5M5 20h14",hand:"M8 12V6a1.5 1.5 0 0 1 3 0v5V4.5a1.5 1.5 0 0 1 3 0V11V6a1.5 1.5 0 0 1 3 0v8c0 4-2 6-5.5 6S7 18 6 15l-1-2.5c-.5-1.5 1.5-2.3 2.2-1z"};function _u(n){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",B1[n]),e.append(t),e}function fi(n,e,t,i){let s=Object.assign(document.createElement("button"),{type:"button",className:`icon ${n}`});return s.append(_u(n)),To(s,e,t),s.addEventListener("click",()=>i(s)),s}function To(n,e,t){n.title=t?`${e} (${t})`:e,n.setAttribute("aria-label",e)}function qa(n,e){n.dataset.icon!==e&&(n.dataset.icon=e,n.replaceChildren(_u(e)))}var If=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"],[1e-12,"p"]];function Lf(n,e,t=1e-6){if(n==null||!Number.isFinite(n))return{number:"–",unit:e};let i=Math.abs(n);if(i<.005*t)return{number:"0",unit:e};let[s,r]=If[If.length-1];for(let[o,a]of If)if(i>=.9995*o||o<=t){[s,r]=[o,a];break}return{number:Zs(n/s),unit:r+e}}function Zs(n){let e=Math.abs(n);return n.toFixed(e<9.995?2:e<99.95?1:0)}function Gn(n,e,t){let{number:i,unit:s}=Lf(n,e,t);return i==="–"?i:`${i} ${s}`}function xr(n){if(!Number.isFinite(n))return"–";if(n<60)return`${n.toFixed(1)} s`;let e=Math.floor(n);return`${Math.floor(e/60)}:${String(e%60).padStart(2,"0")} min`}function ii(n,e,t=`${e}s`){return`${n} ${n===1?e:t}`}var k1={device_lost:"the hand was lost",watchdog:"the haptic loop stood still",not_finite:"a number was not finite",too_fast:"the hand moved too fast",pose_jump:"the hand jumped",turned_too_fast:"the hand turned too fast",orientation_jump:"the hand's direction jumped",contact_stale:"the contact model was too old"},z1={grasped:"The hand took hold of the object",released:"The hand let the object go",armed:"Forces are on",disarmed:"Forces are off",late:"Late",recording_ended:"The recording has ended",not_armed:"Forces stay off",resumed:"Goes on",parameter:"Parameter changed",fault:"Fault",held_back:"Held back",squeezed:"Squeezed"},Nf={fault:"ended by a fault",duration:"reached its duration",device_finished:"the hand has finished",stopped:"was stopped"},V1={hand:"simulated hand",web:"mouse or touch",script:"scripted hand",replay:"recorded hand",null:"no hand","":"a recording"};function gg(n){return V1[String(n).split(":")[0]]??n}function vr(n){return k1[n]??String(n).replaceAll("_"," ")}function xu({reason:n,fault:e}){let t=Nf[n];return!t||n!=="fault"||!e?t:`${t}: ${vr(e.name)}${e.text?` (${e.text})`:""}`}function _g(n,e){return!n||!(e-n.time<6)?null:`The computer was late (${n.count===1?"once":`${n.count} times so far`}): ${n.text??vr(n.name)}.`}function vu({kind:n,detail:e,text:t}){let i=z1[n]??String(n).replaceAll("_"," "),r=[n==="fault"||n==="late"?vr(e):n==="held_back"?"":e,t].filter(Boolean).join("; ");return r?`${i}: ${r}`:i}function xg(n){let{object:e,statics:t,grasped:i,contacts:s,clusters:r}=n,o=`The ${e}`;if(s===0)return`${o} ${i?"is in the hand and":"rests and"} touches nothing.`;let a=t.length===1?`the ${t[0]}`:"the scene",l=s===1?"1 contact":`${s} contacts`,c=r===0?"":r===1?" in 1 cluster":` in ${r} clusters`;return n.touching&&n.armed===!1?`${o} touches ${a} at ${l}${c}; forces are off.`:n.touching?`${o} presses on ${a} at ${l}${c}.`:`${o} is close to ${a}: ${l}${c}.`}function vg(n){let{object:e,statics:t,rows:i,pressing:s}=n,r=t.length===1?`the ${t[0]}`:"the scene";if(i===0)return`The ${e} ${n.grasped?"is in the hand and":"rests and"} touches nothing.`;if(s===0)return`The ${e} is close to ${r}: ${i===1?"1 row":`${i} rows`} near, none presses.`;let o=`The ${e} rests on ${s===1?"1 row":`${s} rows`} of ${r}`;return n.armed===!1?`${o}; forces are off.`:`${o}; the hand pulls ${n.newtons}${n.stiffness?`; coupling ${n.stiffness}`:""}.`}function yg({pressing:n,stiffness:e,stretch:t,force:i,heldBack:s,squeezed:r,say:o}){if(r>.1)return"Squeezed: surfaces all around are nearer than the gap that is kept; move it back the way it came.";if(s>.01)return`Held back in ${Math.round(100*s)} % of the last second: the object waits where its contact model ends; move it more slowly.`;if(!(n>0)||!(e>0))return"Nothing limits the object but the coupling.";let a=e*t,l=`${o(e,"N/m")} × ${o(t,"m")}`;return i<.9*a?`The coupling alone limits the force: ${l} would be ${o(a,"N")}; it has levelled off, or the device is at its limit.`:`The coupling alone limits the force: ${l}. The surfaces do not give.`}function Sg(n){return n.filter(({presses:e,friction:t,force:i,normal:s})=>{let r=i.reduce((a,l,c)=>a+l*s[c],0),o=Math.hypot(...i.map((a,l)=>a-r*s[l]));return e&&t>0&&o>.98*t*Math.abs(r)}).length}var G1=["what a hand feels","speed","what the eye sees","the cap on deviation","the budget"];function Mg(n){return G1.map((i,s)=>[i,n.filter(r=>r.decidedBy===s).length]).filter(([,i])=>i>0).sort(([,i],[,s])=>s-i).map(([i,s])=>`${Math.round(100*s/n.length)} % by ${i}`).join(", ")}function Df(n){let e=new Map;for(let{objectLevel:t}of n)e.set(t,(e.get(t)??0)+1);return[...e].sort(([t],[i])=>t-i)}function bg(n){let e=document.getElementById("controls"),t=document.getElementById("view-tools"),i={title:document.getElementById("title"),chip:document.getElementById("state"),open:fi("open","Open a scene or a mesh","O",n.open),pause:fi("pause","Pause","P",n.pause),step:fi("step","One step",".",n.step),reset:fi("reset","Begin again","R",n.reset),record:fi("record","Record","",n.record),theme:fi("theme","Light or dark","",n.theme),help:fi("help","Help","?",n.help),device:document.createElement("select"),views:{},act:n};i.device.title="Who moves the object",i.device.setAttribute("aria-label",i.device.title),i.device.addEventListener("change",()=>n.device(i.device.value));let s=(...o)=>{let a=Object.assign(document.createElement("span"),{className:"group"});return a.append(...o),a};e.append(s(i.open),s(i.device),s(i.pause,i.step,i.reset,i.record),s(i.theme,i.help));let r=[["levels","Levels of detail: finest as wireframe","L","wireframe"],["ghost","Ghost of the hand","G","ghost"],["contacts","Contacts and clusters","C","contacts"],["forces","Force and torque","A","forces"],["names","Names of the objects","N","names"]];for(let[o,a,l,c]of r)i.views[c]=fi(o,a,l,()=>n.view(c)),t.append(i.views[c]);return i.sound=fi("sound","Sound of contact","S",n.sound),Uf(i,!1),t.append(i.sound,fi("fit","Fit the view","F",n.fit)),i}function Uf(n,e){n.sound.setAttribute("aria-pressed",String(e))}function Ff(n,e){for(let[t,i]of Object.entries(n.views))i.setAttribute("aria-pressed",String(e[t]))}function wg(n,e){let{state:t,scene:i,shown:s,connected:r}=e;n.title.textContent=i?.title??"",document.title=i?`${i.title} · Thigma`:"Thigma";let o=r?t?.run??"connecting":"lost",a=s?` · ${xr(s.time)}`:"",l={lost:"connection lost",connecting:"connecting",running:`running${a}`,paused:`paused${a}`,ended:e.progress?"preparing":Nf[t?.reason]??"ended"};t?.late&&(l.running+=` · late ${t.late.count}×`);let c=o==="running"&&(s?.bits&4)!==0;t?.replay&&o==="running"&&(l.running=`replaying${a}`),n.chip.textContent=c?`forces off: ${vr(e.faultName())}`:l[o],n.chip.title=o==="ended"?xu(t)??"":t?.late?.text??"",n.chip.dataset.run=c?"fault":o;let u=r&&!!t,h=t?.run==="paused";qa(n.pause,h?"play":"pause"),To(n.pause,h?"Go on":"Pause","P"),n.pause.disabled=!u||t.run==="ended",n.step.disabled=!u||!h,n.reset.disabled=n.record.disabled=n.open.disabled=!u;let f=!!t?.recording;qa(n.record,f?"stop":"record"),n.record.classList.toggle("on",f),To(n.record,f?`Stop recording ${t.recording}`:"Record from the start",""),H1(n,t,u)}function H1(n,e,t){let i=[...new Set([...e?.devices??[],...e?[e.device]:[]])];n.device.dataset.uris!==i.join(" ")&&(n.device.dataset.uris=i.join(" "),n.device.replaceChildren(...i.map(s=>new Option(gg(s),s)))),n.device.hidden=i.length===0,n.device.disabled=!t||i.length<2,e&&document.activeElement!==n.device&&(n.device.value=e.device)}function Tg(n,e){let t=e?`${e.text}|${e.button??""}`:"";if(n.dataset.key===t||(n.dataset.key=t,n.hidden=!e,!e))return;let i=Object.assign(document.createElement("span"),{textContent:e.text});if(n.className=`hint ${e.mood??""}`,n.replaceChildren(...e.icon?[_u(e.icon)]:[],i),!e.button)return;let s=Object.assign(document.createElement("button"),{type:"button",textContent:e.button});s.addEventListener("click",e.act),n.append(s)}function Ag(){return{step:0,turned:!1,unarmedSince:null,touchedAt:null}}function Eg(n,e,t,i){let{state:s,scene:r,snapshot:o}=e;if(!e.connected||!s||!r||!o)return null;let a=r.object.name,l=(o.bits&32)!==0,c=(o.bits&1)!==0,u=(o.bits&2)!==0,h=(o.bits&4)!==0;if(e.progress)return null;let f=e.hello?.may_control===!1;if(s.run==="ended")return{text:`The session ${xu(s)??"has ended"}.`,button:f?void 0:"Begin again",act:i.reset,mood:"stop"};if(e.refusal&&t.now<e.refusal.until)return{text:e.refusal.text,mood:"stop"};if(f)return{text:"This page watches. To do more, open the address with its token, as the program has printed it."};if(s.replay)return{text:`A recording: ${s.replay.file.split("/").pop()}`,button:s.devices.includes("web:")?"Take it yourself":void 0,act:()=>i.device("web:")};if(h){let g=s.device.startsWith("web:");return{text:`Forces are off: ${vr(e.faultName())}.${g?` Take hold of the ${a} again to go on.`:""}`,button:g?void 0:"Begin again",act:i.reset,mood:"stop"}}let p=_g(s.late,o.time);return p?{text:p,mood:"stop"}:s.device.startsWith("web:")?s.holder==="other"?{text:"Another page holds the hand; this one watches."}:W1(n,{object:a,grasped:c,armed:u,fading:l,snapshot:o,scene:r,...t}):s.devices.includes("web:")?{text:`A ${s.simulated===!1?"device":"simulated hand"} moves the ${a}.`,button:"Take it yourself",act:()=>i.device("web:"),icon:"hand"}:null}function W1(n,e){let{object:t,grasped:i,armed:s,now:r,newtons:o}=e;if(!i||!e.holding)return n.unarmedSince=null,{text:`Drag the blue ${t}.`,icon:"hand"};if(s?n.unarmedSince=null:n.unarmedSince??=r,!s&&r-n.unarmedSince>.6)return{text:`Taken hold of inside a contact: lift the ${t} off once, then forces come on.`};if(e.fading)return{text:"This page is slow: the force fades until it keeps up, and comes back by itself."};if(o>0&&(n.touchedAt??=r),n.touchedAt===null){let a=e.scene.statics[0]?.name??"scene",l=e.touch?"spread two fingers to move it away":"Shift-drag or the wheel moves it deeper";return{text:`Press it against the ${a}: ${l}. The arrow will be the force in your hand.`}}return!n.turned&&e.turned&&(n.turned=!0),!n.turned&&r-n.touchedAt<12?{text:e.touch?"Two fingers turn it. A finger beside it turns the view.":"Ctrl-drag turns it. Space lets go. Right-drag turns the view."}:null}var yr={grasped:1,armed:2,fault:4,paused:8,ended:16,fading:32,heldBack:64,squeezed:128,constrained:256};var Of=64;var $a=16,X1=48,yu=48;var Ya=class extends Error{},_n=(n,e)=>{if(!n)throw new Ya(e)};function Cg(n){_n(n.byteLength>=$a,`a message of ${n.byteLength} bytes has no header`);let e=new DataView(n),t=e.getUint8(0),i=e.getUint8(1),s={bits:e.getUint16(2,!0),count:e.getUint32(4,!0),time:e.getFloat64(8,!0)},r={1:q1,2:Z1,3:J1,4:$1,5:Y1};return _n(r[t],`message type ${t} is not known`),_n(i===1,`layout ${i} of message type ${t} is not known`),r[t](n,e,s)}function Za(n,e,t){_n(n.byteLength===e,`${t} of ${n.byteLength} bytes, ${e} expected`)}function Bf(n,e){let t=e;return(i,s)=>{let r=new i(n,t,s);return t+=4*s,r}}function kf({positions:n,triangles:e,patchOfTriangle:t},i,s,r){_n(n.every(Number.isFinite),`${r} with a position that is no number`),_n(e.every(o=>o<i),`${r} with a triangle of a vertex that is not there`),_n(t.every(o=>o<s||o===4294967295),`${r} with a triangle of a patch that is not there`)}function q1(n,e,{count:t}){_n(n.byteLength>=32,`mesh of ${n.byteLength} bytes, 32 at least`);let[i,s,r,o]=[16,20,24,28].map(c=>e.getUint32(c,!0));Za(n,32+12*i+16*s+4*r+8*o,"mesh");let a=Bf(n,32),l={kind:"mesh",number:t,positions:a(Float32Array,3*i),triangles:a(Uint32Array,3*s),patchOfTriangle:a(Uint32Array,s),nodeOfPatch:a(Int32Array,r),parents:a(Int32Array,o),levels:a(Int32Array,o)};return kf(l,i,r,"mesh"),_n(l.nodeOfPatch.every(c=>c>=0&&c<o),"mesh with a patch of a node that is not there"),_n(l.parents.every(c=>c>=-1&&c<o),"mesh with a parent that is not there"),_n(l.levels.every(c=>c>=0),"mesh with a negative level"),l}function $1(n,e,{bits:t,count:i}){_n(n.byteLength>=32,`level of ${n.byteLength} bytes, 32 at least`);let[s,r,o]=[16,20,24].map(c=>e.getUint32(c,!0));Za(n,32+12*s+16*r+4*o,"level");let a=Bf(n,32),l={kind:"level",number:i,level:t,positions:a(Float32Array,3*s),triangles:a(Uint32Array,3*r),patchOfTriangle:a(Uint32Array,r),nodeOfPatch:a(Int32Array,o)};return _n(t>0,"level 0 comes as a mesh"),kf(l,s,o,"level"),_n(l.nodeOfPatch.every(c=>c>=-1),"level with a patch of no node that could be"),l}function Y1(n,e,{count:t}){_n(n.byteLength>=32,`relief of ${n.byteLength} bytes, 32 at least`);let[i,s,r]=[16,20,24].map(l=>e.getUint32(l,!0));Za(n,32+12*i+16*s,"relief");let o=Bf(n,32),a={kind:"relief",number:t,patches:r,positions:o(Float32Array,3*i),triangles:o(Uint32Array,3*s),patchOfTriangle:o(Uint32Array,s)};return kf(a,i,r,"relief"),a}function Z1(n,e,{bits:t,count:i,time:s}){return _n(t>0,"channels without a column"),_n(Number.isFinite(s),"channels without a time"),Za(n,$a+4*t*i,"channels"),{kind:"channels",columns:t,rows:i,time:s,values:new Float32Array(n,$a,t*i)}}function J1(n,e,{bits:t,count:i,time:s}){_n(n.byteLength>=240,`snapshot of ${n.byteLength} bytes, 240 at least`);let r=e.getUint32(216,!0),o=e.getUint32(236,!0);Za(n,240+yu*(i+r+o),"snapshot");let a=new Float32Array(n,24,X1),l=h=>[a[h],a[h+1],a[h+2]],c=h=>({position:l(h),quaternion:[a[h+3],a[h+4],a[h+5],a[h+6]]}),u={kind:"snapshot",time:s,bits:t,frame:e.getFloat64(16,!0),object:c(0),ghost:c(7),handle:c(14),grasp:l(21),force:l(24),torque:l(27),contactForce:l(30),contactTorque:l(33),center:l(36),penetration:a[39],stretch:a[40],energy:a[41],modelAge:a[42],modelWeight:a[43],hapticRate:a[44],contactRate:a[45],queryCpu:a[46],metresPerNewton:a[47],contactsFound:e.getUint32(220,!0),contactsDropped:e.getUint32(224,!0),front:e.getUint32(228,!0),fault:e.getUint32(232,!0),contacts:[],clusters:[],rows:[]};_n(a.subarray(0,24).every(Number.isFinite),"snapshot with a pose that is no number");for(let h=0;h<i;h++)u.contacts.push(K1(e,240+yu*h));for(let h=0;h<r;h++)u.clusters.push(j1(e,240+yu*(i+h)));for(let h=0;h<o;h++)u.rows.push(Q1(e,240+yu*(i+r+h)));return u}var Js=(n,e,t)=>Array.from({length:t},(i,s)=>n.getFloat32(e+4*s,!0));function K1(n,e){let t=n.getUint32(e+44,!0);return{point:Js(n,e,3),normal:Js(n,e+12,3),depth:n.getFloat32(e+24,!0),bound:n.getFloat32(e+28,!0),body:n.getInt32(e+32,!0),objectNode:n.getInt32(e+36,!0),sceneNode:n.getInt32(e+40,!0),objectLevel:t&255,sceneLevel:t>>8&255,status:t>>16&255,decidedBy:t>>>24}}function j1(n,e){return{point:Js(n,e,3),normal:Js(n,e+12,3),depth:n.getFloat32(e+24,!0),force:Js(n,e+28,3),id:n.getInt32(e+40,!0)}}function Q1(n,e){let t=n.getUint32(e+44,!0);return{point:Js(n,e,3),normal:Js(n,e+12,3),gap:n.getFloat32(e+24,!0),force:Js(n,e+28,3),friction:n.getFloat32(e+40,!0),kind:t&3,presses:(t&4)!==0}}function Rg(n){let e=null;try{e=JSON.parse(n)}catch{}return _n(e&&typeof e=="object"&&typeof e.type=="string","a text message without a type"),e}function Pg(n){let e=new ArrayBuffer($a+n.length),t=new DataView(e);return t.setUint8(0,33),t.setUint8(1,1),t.setUint32(4,n.length,!0),new Uint8Array(e,$a).set(n),e}var tT=.004,Ig=9.9;function Lg(){return{position:[0,0,0],quaternion:[0,0,0,1],clutch:!1,pending:[],latest:-1/0}}function zf(n,e){return[n[3]*e[0]+n[0]*e[3]+n[1]*e[2]-n[2]*e[1],n[3]*e[1]-n[0]*e[2]+n[1]*e[3]+n[2]*e[0],n[3]*e[2]+n[0]*e[1]-n[1]*e[0]+n[2]*e[3],n[3]*e[3]-n[0]*e[0]-n[1]*e[1]-n[2]*e[2]]}var Vf=n=>[-n[0],-n[1],-n[2],n[3]];function Ng(n,e){let[t,i,s]=zf(zf(n,[...e,0]),Vf(n));return[t,i,s]}function nT(n,e){let t=Math.sin(.5*e);return[t*n[0],t*n[1],t*n[2],Math.cos(.5*e)]}function Dg(n,e,t){let i=Ng(Vf(t.quat_xyzw),e);n.position=n.position.map((s,r)=>Math.max(-Ig,Math.min(Ig,s+i[r]/t.motion_scale)))}function Su(n,e,t,i){let s=Ng(Vf(i.quat_xyzw),e),r=zf(nT(s,t),n.quaternion),o=Math.hypot(...r);n.quaternion=r.map(a=>a/o)}function iT(n,e,t=-1/0){let i=n[n.length-1],s=n[n.length-2]?.time??t;i&&i.buttons===e.buttons&&i.time-s<tT?n[n.length-1]=e:n.push(e),n.length>Of&&n.splice(0,n.length-Of)}var Gf=n=>({position:[...n.position],quaternion:[...n.quaternion]});function Ao(n,e,t=Gf(n)){let i={time:Math.max(e,n.latest),...t,buttons:n.clutch?1:0};iT(n.pending,i,n.sent),n.latest=i.time}function Hf(n){let e=n.pending;return n.pending=[],e.length>0&&(n.sent=e[e.length-1].time),e}function Ug(n,e,t,i=.7){let s=e.length/3,r=n.length/3,o=new Float64Array(e.length),a=new Float64Array(e.length);for(let d=0;d<s;d++)sT(n,e,d,o,a);let l=new Uint32Array(r+1);for(let d of e)l[d+1]++;for(let d=0;d<r;d++)l[d+1]+=l[d];let c=new Uint32Array(e.length),u=l.slice();for(let d=0;d<e.length;d++)c[u[e[d]]++]=d;let h=[],f=[],p=[],g=new Uint32Array(e.length),v=Math.cos(i);for(let d=0;d<r;d++){let m=c.subarray(l[d],l[d+1]),y=new Map;for(let C of m){let b=3*Math.floor(C/3),P=0,A=0,x=0,T=0;for(let I=0;I<m.length;I++){let k=3*Math.floor(m[I]/3),V=a[b]*a[k]+a[b+1]*a[k+1]+a[b+2]*a[k+2];k!==b&&!(V>v)&&m.length<=31||(T|=1<<(I&31),P+=o[k],A+=o[k+1],x+=o[k+2])}let B=t[Math.floor(C/3)],D=B*2**32+(T>>>0);if(!y.has(D)){y.set(D,h.length/3),p.push(B),h.push(n[3*d],n[3*d+1],n[3*d+2]);let I=Math.hypot(P,A,x)||1;f.push(P/I,A/I,x/I)}g[C]=y.get(D)}}return{positions:Float32Array.from(h),normals:Float32Array.from(f),labels:Float32Array.from(p),index:g}}function sT(n,e,t,i,s){let r=3*e[3*t],o=3*e[3*t+1],a=3*e[3*t+2],l=n[o]-n[r],c=n[o+1]-n[r+1],u=n[o+2]-n[r+2],h=n[a]-n[r],f=n[a+1]-n[r+1],p=n[a+2]-n[r+2],g=[c*p-u*f,u*h-l*p,l*f-c*h],v=Math.hypot(g[0],g[1],g[2]);for(let d=0;d<3;d++)i[3*t+d]=g[d],s[3*t+d]=v>0?g[d]/v:0}function Fg(n){let e=new Float64Array(n.length),t=n.reduce((s,r)=>Math.max(s,r),0)+1;for(let s=0;s<n.length;s++){let r=n[s],o=n[s%3===2?s-2:s+1];e[s]=Math.min(r,o)*t+Math.max(r,o)}e.sort();let i=[];for(let s=0;s<e.length;s++)s>0&&e[s]===e[s-1]||i.push(Math.floor(e[s]/t),e[s]%t);return Uint32Array.from(i)}function Og(n){let e=10**Math.floor(Math.log10(n));return e*[5,2,1].find(t=>t*e<=n*(1+1e-9))}function Wf(n){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let s=0;s<n.length;s++){let r=s%3;n[s]<e[r]&&(e[r]=n[s]),n[s]>t[r]&&(t[r]=n[s])}let i=e.map((s,r)=>.5*(s+t[r]));return{min:e,max:t,center:i,radius:.5*Math.hypot(...e.map((s,r)=>t[r]-s))}}function Bg(n){let e=new gn,t=new kt(n,new Vs({colorWrite:!1,transparent:!0}));t.onBeforeRender=s=>s.clearDepth();let i=new kt(n,new ti({transparent:!0,depthWrite:!1,uniforms:{tone:{value:new Xe}},vertexShader:`varying vec3 facing; varying vec3 toEye;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  facing = normalize(normalMatrix * normal);
  toEye = -seen.xyz;
  gl_Position = projectionMatrix * seen;
}`,fragmentShader:`varying vec3 facing; varying vec3 toEye; uniform vec3 tone;
void main() {
  float rim = 1.0 - abs(dot(normalize(facing), normalize(toEye)));
  gl_FragColor = vec4(tone, 0.10 + 0.55 * rim * rim * rim);
  #include <colorspace_fragment>
}`}));return t.renderOrder=10,i.renderOrder=11,e.add(t,i),e.visible=!1,{group:e,hidden:t,glass:i}}function kg(n,e){n.hidden.geometry=n.glass.geometry=e}function zg({object:n,ghost:e},t){let i=Math.hypot(...n.position.map((o,a)=>o-e.position[a])),s=new Nn(...n.quaternion),r=new Nn(...e.quaternion);return i/t+s.angleTo(r)}var Vg=n=>new Xe(n).toArray(),Sr={from:[2.3,-1.5,3.6],colour:16774372,tone:Vg(16774372),strength:2.6},Mr={from:[-2.2,2.2,1.2],colour:13624319,tone:Vg(13624319),strength:.9};function Gg(n){let e=new Ta(16777215,9077624,1.5);e.position.set(0,0,1);let t=new mo(Sr.colour,Sr.strength);t.position.set(...Sr.from),t.castShadow=!0,t.shadow.mapSize.setScalar(1536),Object.assign(t.shadow.camera,{left:-1.5,right:1.5,top:1.5,bottom:-1.5,near:.5,far:9}),t.shadow.radius=4,t.shadow.bias=-6e-4,t.shadow.normalBias=.006;let i=new mo(Mr.colour,Mr.strength);i.position.set(...Mr.from);let s=new Ca(16777215,.18);return n.add(e,t,i,s),{sky:e,key:t,rim:i,fill:s}}function Hg(n){let e=new kt(new ur(12,12),new Sa({opacity:.2}));return e.receiveShadow=!0,e.renderOrder=-1,n.add(e),e}var Wg="thigma-theme";function Mu(){let n=document.documentElement.dataset.theme;return n||(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light")}function Xg(n){let e=null;try{e=localStorage.getItem(Wg)}catch{}return(e==="light"||e==="dark")&&(document.documentElement.dataset.theme=e),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>n()),function(){let i=Mu()==="dark"?"light":"dark";document.documentElement.dataset.theme=i;try{localStorage.setItem(Wg,i)}catch{}n()}}function Nt(n){return getComputedStyle(document.documentElement).getPropertyValue(`--${n}`).trim()}var ws=["#0a8f83","#23ab6a","#7cc542","#bdd334","#e6d32e","#f5a32b","#ea7430","#d64a45"];function br(n){return ws[Math.max(0,Math.min(ws.length-1,n))]}var qf=512,Yg=16,ja=new W(0,0,1);function Ks(n={}){return new ba(n)}function wr(n={}){return new Vs({transparent:!0,opacity:.42,depthTest:!1,depthWrite:!1,...n})}function Zg(){let n=new gn,e=new Ui(.5,.5,1,20).rotateX(Math.PI/2).translate(0,0,.5),t=new ys(1.35,3.6,28).rotateX(Math.PI/2).translate(0,0,1.8),i=[];for(let s of[Ks(),wr()]){let r=new kt(e,s),o=new kt(t,s);r.renderOrder=o.renderOrder=s.depthTest?0:20,i.push({shaft:r,head:o,material:s}),n.add(r,o)}return n.visible=!1,{group:n,parts:i}}function Jg(n,e,t,i){let s=t.length();if(n.group.visible=s>.2*i,!n.group.visible)return;n.group.position.copy(e),n.group.quaternion.setFromUnitVectors(ja,t.clone().divideScalar(s));let r=Math.min(i,s/3.6);for(let{shaft:o,head:a}of n.parts)o.scale.set(r,r,Math.max(1e-6*i,s-3.4*r)),a.scale.setScalar(r),a.position.set(0,0,s-3.6*r)}function Kg(n,e){for(let{material:t}of n.parts)t.color.set(e)}var Ja=72,Ts=10,qg=.055;function jg(){let n=new gn,e=rT(),t=new ys(.15,.38,24),i=[];for(let s of[Ks(),wr()]){let r=new kt(e,s),o=new kt(t,s);r.renderOrder=o.renderOrder=s.depthTest?0:20,i.push({ring:r,head:o,material:s}),n.add(r,o)}return n.visible=!1,{group:n,parts:i,ring:e}}function rT(){let n=[],e=[],t=[];for(let s=0;s<=Ja;s++){let r=2*Math.PI*s/Ja;for(let o=0;o<Ts;o++){let a=2*Math.PI*o/Ts,l=Math.cos(a),c=Math.sin(a);e.push(l*Math.cos(r),l*Math.sin(r),c);let u=1+qg*l;n.push(u*Math.cos(r),u*Math.sin(r),qg*c);let h=(o+1)%Ts;if(s<Ja){let f=s*Ts+o,p=s*Ts+h;t.push(f,p,f+Ts,p,p+Ts,f+Ts)}}}let i=new Un;return i.setAttribute("position",new ln(Float32Array.from(n),3)),i.setAttribute("normal",new ln(Float32Array.from(e),3)),i.setIndex(t),i}function Qg(n,e,t,i,s){if(n.group.visible=i>.01&&t.lengthSq()>0,!n.group.visible)return;n.group.position.copy(e),n.group.quaternion.setFromUnitVectors(ja,t.clone().normalize()),n.group.scale.setScalar(s);let r=Math.max(1,Math.round(300/360*Ja*Math.min(1,i)));n.ring.setDrawRange(0,r*Ts*6);let o=2*Math.PI*r/Ja;for(let{head:a}of n.parts)a.position.set(Math.cos(o),Math.sin(o),0),a.rotation.set(0,0,o),a.scale.setScalar(Math.min(1,.25+4*i))}function e0(n,e){for(let{material:t}of n.parts)t.color.set(e)}function bu(n,e,t,i,s){let r=new ma(e,t,i);return r.frustumCulled=!1,r.renderOrder=s,r.count=0,r.setColorAt(0,new Xe),n.add(r),r}function t0(){let n=new gn,e=new Hs(1,12,8),t=new Ui(.22,.22,1,8).rotateX(Math.PI/2).translate(0,0,.5),i=new ya(1,.12,8,40),s=(...o)=>bu(n,...o),r={group:n,dots:[],needles:[],rings:[]};for(let[o,a]of[[Ks(),1],[wr({opacity:.45}),21]])r.dots.push(s(e,o,qf,a)),r.needles.push(s(t,o,qf,a));for(let[o,a]of[[Ks(),1],[wr({opacity:.55}),22]])r.rings.push(s(i,o,Yg,a));return r}var $g=new yt,$f=new Nn,Yf=new W,Zf=new W,Jf=new Xe;function Kf(n,e,t,i,s){let r=Math.min(qf,e.length);for(let a=0;a<r;a++){let{point:l,normal:c,level:u}=e[a];Yf.set(...l),$f.setFromUnitVectors(ja,Zf.set(...c).normalize()),Jf.set(br(u)),Xf(n.dots,a,i,i),Xf(n.needles,a,i,5.5*i)}Ka(n.dots,r),Ka(n.needles,r);let o=Math.min(Yg,t.length);for(let a=0;a<o;a++){Yf.set(...t[a].point),$f.setFromUnitVectors(ja,Zf.set(...t[a].normal).normalize()),Jf.set(s);let l=i*(2.6+2.4*Math.sqrt(Math.max(0,Math.min(1,t[a].share))));Xf(n.rings,a,l,l)}Ka(n.rings,o)}function Xf(n,e,t,i){$g.compose(Yf,$f,Zf.set(t,t,i));for(let s of n)s.setMatrixAt(e,$g),s.setColorAt(e,Jf)}function Ka(n,e){for(let t of n)t.count=e,t.instanceMatrix.needsUpdate=!0,t.instanceColor&&(t.instanceColor.needsUpdate=!0)}function n0(){let n=Ks(),e=wr({opacity:.5}),t=new gn,i=new Ui(1,1,1,10).rotateX(Math.PI/2).translate(0,0,.5),s=new Hs(1,16,12),r=[],o=[];for(let a of[n,e]){let l=new kt(i,a),c=new kt(s,a);l.renderOrder=c.renderOrder=a.depthTest?0:23,r.push(l),o.push(c),t.add(l,c)}return{group:t,rods:r,knobs:o,materials:[n,e]}}function i0(n,e,t,i){let s=t.clone().sub(e),r=s.length();n.group.position.copy(e),r>0&&n.group.quaternion.setFromUnitVectors(ja,s.divideScalar(r));for(let o of n.rods)o.scale.set(i,i,Math.max(r,1e-9*i));for(let o of n.knobs)o.position.set(0,0,r),o.scale.setScalar(2.6*i)}function s0(n,e){for(let t of n.materials)t.color.set(e)}var Qf=64,jf=new W(0,0,1);function a0(){let n=new gn,e={planes:new Ui(1,1,.06,28).rotateX(Math.PI/2),points:new Hs(.36,12,8),forces:new Ui(.16,.16,1,8).rotateX(Math.PI/2).translate(0,0,.5),heads:new ys(.42,1,16).rotateX(Math.PI/2).translate(0,0,.5),cones:new ys(1,1,28,1,!0).translate(0,-.5,0).rotateX(-Math.PI/2)},t={group:n};for(let[i,s]of Object.entries(e)){let r=i==="cones"||i==="planes",o=r?Ks({transparent:!0,opacity:i==="cones"?.34:.72,depthWrite:!1,side:2}):Ks(),a=wr({opacity:r?.16:.5,side:r?2:0});t[i]=[bu(n,s,o,Qf,r?3:2),bu(n,s,a,Qf,22)]}return t}var r0=new yt,wu=new Nn,Qa=new W,Tu=new W,oT=new W,o0=new Xe;function ed(n,e,{size:t,longest:i},s){let r=e.slice(0,Qf),o=Math.max(1e-30,...r.map(({force:c})=>Math.hypot(...c))),a={planes:0,points:0,forces:0,heads:0,cones:0},l=(c,u,h)=>{r0.compose(Qa,wu,oT.set(u,u,h));for(let f of n[c])f.setMatrixAt(a[c],r0),f.setColorAt(a[c],o0);a[c]+=1};for(let{point:c,normal:u,gap:h,force:f,friction:p,kind:g,presses:v}of r){o0.set(v?s.press:s.near);let d=c.map((P,A)=>P+h*u[A]),m=v?t:.62*t;if(wu.setFromUnitVectors(jf,Tu.set(...u).normalize()),Qa.set(...g===1?d:c),l("points",m,m),Qa.set(...g===1?c:d),l(g===2?"points":"planes",m,m),!v)continue;Qa.set(...c),p>0&&(wu.setFromUnitVectors(jf,Tu.set(...u).multiplyScalar(-1).normalize()),l("cones",.8*i*p,.8*i));let y=Math.hypot(...f);if(!(y>0))continue;wu.setFromUnitVectors(jf,Tu.set(...f).divideScalar(y));let C=i*(.25+.75*y/o),b=Math.min(1.1*t,.5*C);l("forces",t,C-b),Qa.addScaledVector(Tu,C-b),l("heads",t,b)}for(let[c,u]of Object.entries(a))Ka(n[c],u)}function c0(n,e){let{positions:t,triangles:i,patchOfTriangle:s}=n,r=t.length/3,o=new Uint32Array(r),a=new Map,l=(v,d)=>Math.floor(t[3*v+d]/e)+1e5;for(let v=0;v<r;v++){let d=(l(v,0)*2e5+l(v,1))*2e5+l(v,2),m=a.get(d);m===void 0&&a.set(d,m=a.size),o[v]=m}let c=new Float32Array(3*a.size),u=new Uint32Array(a.size),h=new Float64Array(3*a.size);for(let v=0;v<r;v++){u[o[v]]+=1;for(let d=0;d<3;d++)h[3*o[v]+d]+=t[3*v+d]}for(let v=0;v<c.length;v++)c[v]=h[v]/u[Math.floor(v/3)];let f=0;for(let v=0;v<r;v++){let d=0;for(let m=0;m<3;m++)d+=(t[3*v+m]-c[3*o[v]+m])**2;f=Math.max(f,d)}let p=[],g=[];for(let v=0;v<i.length;v+=3){let[d,m,y]=[o[i[v]],o[i[v+1]],o[i[v+2]]];d===m||m===y||y===d||(p.push(d,m,y),g.push(s[v/3]))}return{mesh:{...n,positions:c,triangles:Uint32Array.from(p),patchOfTriangle:Uint32Array.from(g)},deviation:Math.sqrt(f)}}var l0=[.064,.032,.016,.008],aT=.6,lT=4e3;function u0(n,e,t,i,s){if(e<lT)return 0;for(let r=0;r<l0.length;r++){let o=-1-r,a=l0[r]*t;if(!n.has(o)&&aT*a>i)continue;if((n.get(o)??s(o,a))<=i)return o}return 0}function h0(n,e,t){let i=0;return(n??[]).forEach(({free:s,triangles:r,deviation:o},a)=>{a>0&&!s&&r>0&&Number.isFinite(o)&&o!==null&&o<=t*e&&r<n[i].triangles&&(i=a)}),i}function f0(n,e){for(let t=n;t>0;t--)if(e(t))return t;return 0}function d0(n,e,t){let i=new Float64Array(3*t).fill(1/0),s=new Float64Array(3*t).fill(-1/0);for(let o=0;o<e.length;o++)for(let a=0;e[o]>=0&&a<3;a++){let l=3*e[o]+a,c=n[3*o+a];c<i[l]&&(i[l]=c),c>s[l]&&(s[l]=c)}let r=new Float32Array(4*t).fill(-1);for(let o=0;o<t;o++){if(!(i[3*o]<=s[3*o]))continue;let a=0;for(let l=0;l<3;l++)r[4*o+l]=.5*(i[3*o+l]+s[3*o+l]),a+=(s[3*o+l]-i[3*o+l])**2;r[4*o+3]=.5*Math.sqrt(a)}return r}function p0(n,e,t,i){i.fill(0);for(let{point:[s,r,o]}of e)for(let a=0;a<i.length;a++){let l=n[4*a+3]+t;if(n[4*a+3]<0)continue;let c=n[4*a]-s,u=n[4*a+1]-r,h=n[4*a+2]-o;c*c+u*u+h*h<l*l&&(i[a]=255)}}function m0(n,e){let t=e.length,i=new Uint32Array(t);for(let f of n)i[f]++;let s=uT(e),r=i.slice();for(let f=t-1;f>=0;f--){let p=s[f];e[p]>=0&&(r[e[p]]+=r[p])}let o=new Uint32Array(t),a=new Uint32Array(t),l=new Uint32Array(t),c=0;for(let f of s){let p=e[f];o[f]=p<0?c:l[p],a[f]=o[f]+r[f],p<0?c=a[f]:l[p]=a[f],l[f]=o[f]+i[f]}let u=new Uint32Array(n.length),h=o.slice();for(let f=0;f<n.length;f++)u[h[n[f]]++]=f;return{order:u,begin:o,end:a}}function uT(n){let e=n.map(()=>0);for(let r of n)r>=0&&e[r]++;let t=new Uint32Array(n.length),i=n.length,s=[];for(let r=0;r<n.length;r++)e[r]===0&&s.push(r);for(;s.length>0;){let r=s.pop();t[--i]=r,n[r]>=0&&--e[n[r]]===0&&s.push(n[r])}if(i!==0)throw new RangeError("the hierarchy runs in a circle");return t}function g0(n,e,t){t.fill(0);for(let{node:i,level:s}of e)if(!(i<0||i>=n.begin.length))for(let r=n.begin[i];r<n.end[i];r++){let o=n.order[r];(t[o]===0||t[o]>s+1)&&(t[o]=Math.min(255,s+1))}}var _0=(n,e)=>n.patchOfTriangle[e]===4294967295?-1:n.patchOfTriangle[e];function x0(n,e,t,i){return Int32Array.from(n,s=>{let r=s;for(;e[r]>=0&&t[e[r]]<=i;)r=e[r];return r})}function v0(n,e,t,i){i.fill(0);let s=t.filter(({node:r})=>r>=0&&r<n.begin.length);for(let r=0;r<e.length;r++){let o=e[r];if(!(o<0||o>=n.begin.length))for(let{node:a,level:l}of s)n.begin[a]<=n.begin[o]&&n.end[o]<=n.end[a]&&(i[r]===0||i[r]>l+1)&&(i[r]=Math.min(255,l+1))}}function y0(n){let e=n*.61803398875%1,t=[.62,.5,.72][n%3],i=.55,s=r=>{let o=(r+e*12)%12;return Math.round(255*(t-i*Math.min(t,1-t)*Math.max(-1,Math.min(o-3,9-o,1))))};return[s(0),s(8),s(4)]}var Eo=24,js=1024;function M0(n){return{patchLevels:{value:n},spotCount:{value:0},spotRadius:{value:1},spots:{value:Array.from({length:Eo},()=>new Bt)},levelColours:{value:ws.map((e,t)=>new Xe(br(t)))},onlyActive:{value:0},patchTints:{value:null},tinted:{value:0}}}var b0=`attribute float patchNumber;
uniform sampler2D patchLevels;
uniform sampler2D patchTints;
uniform float tinted;
varying vec3 meshPoint;
flat varying vec2 patchState;
flat varying vec4 patchTint;`,w0=`meshPoint = position;
patchState = vec2(0.0);
patchTint = vec4(0.0);
if (patchNumber >= 0.0) {
  int patchIndex = int(patchNumber + 0.5);
  ivec2 cell = ivec2(patchIndex % ${js}, patchIndex / ${js});
  patchState = floor(texelFetch(patchLevels, cell, 0).rg * 255.0 + 0.5);
  if (tinted > 0.5) patchTint = vec4(texelFetch(patchTints, cell, 0).rgb, 1.0);
}`,T0=`varying vec3 meshPoint;
flat varying vec2 patchState;
flat varying vec4 patchTint;
uniform int spotCount;
uniform float spotRadius;
uniform float onlyActive;
uniform vec4 spots[${Eo}];
uniform vec3 levelColours[${ws.length}];
/// The colour of a point of the surface: its own, of its patch, or of a contact nearby.
vec3 markedColour(vec3 base) {
  int level = int(patchState.x) - 1;
  float share = level >= 0 ? 0.92 : 0.0;
  if (level < 0 && patchState.y > 0.5) {
    float nearest = 1.0;
    for (int k = 0; k < ${Eo}; k++) {
      if (k >= spotCount) break;
      float d = distance(meshPoint, spots[k].xyz) / spotRadius;
      if (d < nearest) { nearest = d; level = int(spots[k].w); }
    }
    share = 0.85 * (1.0 - smoothstep(0.3, 1.0, nearest));
  }
  if (onlyActive > 0.5 && share < 0.02) discard;
  vec3 tone = levelColours[clamp(level, 0, ${ws.length-1})];
  if (patchTint.a > 0.5) return mix(patchTint.rgb, tone, 0.75 * step(0.9, share));
  return mix(base, tone, share);
}`;function A0(n){let e=new Ma({roughness:.62,metalness:0});return e.onBeforeCompile=t=>{Object.assign(t.uniforms,n),t.vertexShader=t.vertexShader.replace("#include <common>",`#include <common>
${b0}`).replace("#include <begin_vertex>",`#include <begin_vertex>
${w0}`),t.fragmentShader=t.fragmentShader.replace("#include <common>",`#include <common>
${T0}`).replace("#include <color_fragment>",`#include <color_fragment>
diffuseColor.rgb = markedColour(diffuseColor.rgb);`)},e}var td=n=>`vec3(${n.map(e=>e.toFixed(5)).join(", ")})`,S0=({from:n})=>td(new W(...n).normalize().toArray());function E0(n,e,t){return new ti({uniforms:{...n,base:e,sky:t},vertexShader:`${b0}
varying vec3 facing;
void main() {
  ${w0}
  facing = mat3(modelMatrix) * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,fragmentShader:`${T0}
uniform vec3 base;
uniform float sky;
varying vec3 facing;
void main() {
  vec3 n = normalize(facing);
  vec3 light = mix(vec3(0.25, 0.22, 0.19), vec3(1.0), 0.5 + 0.5 * n.z) * sky + ${Sr.strength.toFixed(3)} * ${td(Sr.tone)} * max(0.0, dot(n, ${S0(Sr)}))
    + ${Mr.strength.toFixed(3)} * ${td(Mr.tone)} * max(0.0, dot(n, ${S0(Mr)})) + 0.28;
  vec3 lit = markedColour(base) * light * 0.31831;
  float peak = max(lit.r, max(lit.g, lit.b)), over = peak - 0.76; // bright ones flatten out, as by NeutralToneMapping
  if (over > 0.0) lit *= (1.0 - 0.0576 / (over + 0.24)) / peak;
  gl_FragColor = vec4(lit, 1.0);
  #include <colorspace_fragment>
}`})}function el(n,e=m0(n.nodeOfPatch,n.parents)){let t=n.triangles.length/3,i=n.nodeOfPatch.length,s=Float32Array.from({length:t},(d,m)=>_0(n,m)),r=Ug(n.positions,n.triangles,s),o=new Un;o.setAttribute("position",new ln(r.positions,3)),o.setAttribute("normal",new ln(r.normals,3)),o.setAttribute("patchNumber",new ln(r.labels,1)),o.setIndex(new ln(r.index,1));let a=new Uint8Array(2*js*C0(n)),l=R0(a,Bi),c=M0(l),u={value:new Xe},h={value:1},f={rich:A0(c),plain:E0(c,u,h)};f.rich.color=u.value;let p=new kt(o,f.rich);p.castShadow=p.receiveShadow=!0;let g=new ga(new Un,new ho({transparent:!0,opacity:.16}));g.visible=!1;let v=new gn;return v.add(p,g),{group:v,solid:p,lines:g,uniforms:c,geometry:o,mesh:n,ranges:e,materials:f,colour:u,sky:h,state:a,patchLevels:l,bytes:new Uint8Array(i),near:new Uint8Array(i),balls:d0(r.positions,r.labels,i)}}var C0=n=>Math.max(1,Math.ceil(n.nodeOfPatch.length/js)),hT=new Map([[So,1],[Bi,2],[ni,4]]);function R0(n,e){let t=new cr(n,js,n.length/(js*hT.get(e)),e,zn);return t.unpackAlignment=1,t.needsUpdate=!0,t}function P0(n,e){let{uniforms:t,mesh:i}=n;if(t.tinted.value=e===null?0:1,e===null||n.tintedAt===e)return;let s=i.parents?x0(i.nodeOfPatch,i.parents,i.levels,e):i.nodeOfPatch,r=new Uint8Array(4*js*C0(i));s.forEach((o,a)=>r.set([...y0(Math.max(0,o)),255],4*a)),t.patchTints.value?.dispose(),t.patchTints.value=R0(r,ni),n.tintedAt=e}function Au(n,{base:e,line:t,sky:i}){n.colour.value.set(e),n.sky.value=i,n.lines.material.color.set(t)}function Eu(n,e){n.solid.material=e?n.materials.rich:n.materials.plain}function I0(n,e,t){n.solid.visible=e!=="none",n.uniforms.onlyActive.value=e==="active"?1:0,n.lines.visible=t>0,n.lines.material.opacity=t,t>0&&!n.lines.geometry.index&&(n.lines.geometry.setAttribute("position",new ln(n.mesh.positions,3)),n.lines.geometry.setIndex(new ln(Fg(n.mesh.triangles),1)))}function L0(n,e,t,i,s){let{bytes:r,near:o,balls:a,state:l,uniforms:c}=n;n.mesh.parents?g0(n.ranges,e,r):v0(n.ranges,n.mesh.nodeOfPatch,e,r);let u=t.slice(0,Eo);p0(a,u,i,o);for(let h=0;h<r.length;h++)a[4*h+3]>s&&(r[h]=0),l[2*h]=r[h],l[2*h+1]=o[h];n.patchLevels.needsUpdate=!0,c.spotCount.value=u.length,c.spotRadius.value=i,u.forEach(({point:h,level:f},p)=>c.spots.value[p].set(...h,f))}function N0(n,e,t=Eo){let i=[];for(let s of n){if(i.length===t)break;i.some(o=>o.level===s.level&&fT(o.point,s.point)<e)||i.push(s)}return i}var fT=(n,e)=>Math.hypot(n[0]-e[0],n[1]-e[1],n[2]-e[2]);function D0(n){n.geometry.dispose(),n.patchLevels.dispose(),n.uniforms.patchTints.value?.dispose(),n.lines.geometry.dispose();for(let e of Object.values(n.materials))e.dispose();n.lines.material.dispose()}function nd(n,e){let t=el(n);return{group:t.group,geometry:t.geometry,finest:t,about:e,levels:new Map,made:new Map,relief:null,browsed:null,wireframe:!1,drawn:0,rich:!0,colours:null}}function U0(n,e){return e>0&&!n.levels.has(e)&&Cu(n,e)}function Cu({about:n},e){let t=n.level_list?.[e];return!!t&&!t.free&&t.triangles>0}function F0(n,e){n.levels.has(e.level)||O0(n,e.level,el(e,n.finest.ranges))}function O0(n,e,t){n.levels.set(e,t),n.group.add(t.group),n.colours&&Au(t,n.colours),Eu(t,n.rich),Pu(n)}function B0(n,e){let{nodeOfPatch:t,parents:i,levels:s}=n.finest.mesh;n.relief||e.patches!==t.length||(n.relief=el({...e,nodeOfPatch:t,parents:i,levels:s},n.finest.ranges),n.group.add(n.relief.group),n.colours&&Au(n.relief,n.colours),Eu(n.relief,n.rich),Pu(n))}function id(n,e){n.colours=e;for(let t of tl(n))Au(t,e)}function sd(n,e){n.rich=e;for(let t of tl(n))Eu(t,e)}var tl=n=>[n.finest,...n.levels.values(),...n.relief?[n.relief]:[]],k0=(n,e)=>n.levels.get(e)??n.finest;function Ru(n,{wireframe:e=n.wireframe,browsed:t=n.browsed}){Object.assign(n,{wireframe:e,browsed:t}),Pu(n)}function rd(n,e,t){let{level_list:i,radius:s,triangles:r}=n.about;return i?.some((o,a)=>a>0&&Cu(n,a))?h0(i,e,t):u0(n.made,r,s,t*e,(o,a)=>{let{mesh:l,deviation:c}=c0(n.finest.mesh,a);return O0(n,o,el(l,n.finest.ranges)),n.made.set(o,c),c})}function z0(n,e){let t=e<0?e:f0(e,i=>n.levels.has(i));return t===n.drawn?!1:(n.drawn=t,Pu(n),!0)}var od=(n,e=n.drawn)=>k0(n,e),V0=n=>n.drawn===0&&n.relief?n.relief:od(n),dT=(n,e)=>e!==n.relief&&![...n.made.keys()].some(t=>n.levels.get(t)===e);function Pu(n){let{browsed:e,wireframe:t}=n,i=e===null?t?null:V0(n):k0(n,e);for(let s of tl(n)){let r=e!==null&&s===i;P0(s,r?e:null);let o=s===i?"whole":i===null&&dT(n,s)?"active":"none";I0(s,o,r?.3:t&&e===null&&s===n.finest?.16:0)}}function G0(n,e,t){let i=.03*t,s=.075*t,r=a=>n.levels.get(a),o=n.browsed===null&&!n.wireframe;for(let a of tl(n)){let l=({level:u})=>o?a===V0(n):a===n.finest?!r(u)||n.browsed!==null:a===r(u),c=e.filter(l);L0(a,c,N0(c,i),s,o?2*s:1/0)}}function H0(n){for(let e of tl(n))D0(e)}var nl=[{pixels:2,shadows:!0,rich:!0,off:0},{pixels:1,shadows:!0,rich:!0,off:0},{pixels:1,shadows:!1,rich:!0,off:.5},{pixels:1,shadows:!1,rich:!1,off:.5},{pixels:1,shadows:!1,rich:!1,off:1},{pixels:1,shadows:!1,rich:!1,off:2},{pixels:1,shadows:!1,rich:!1,off:4},{pixels:1,shadows:!1,rich:!1,off:6}],q0=3,pT=1/15,$0=.045,mT=.012,W0=2,gT=3,_T=60;function Y0({step:n=0,fixed:e=!1}={}){return{step:n,fixed:e,seen:0,mean:0,patience:_T,climbed:!1}}function Z0(n,e){if(n.seen+=1,n.fixed||n.seen<=W0)return!1;let t=n.seen-W0;return n.mean+=(e-n.mean)/Math.min(t,8),t>=gT&&n.mean>$0&&n.step<nl.length-1?(n.climbed&&(n.patience*=4),X0(n,1),!0):t>=n.patience&&n.mean<mT&&n.step>0?(X0(n,-1),!0):!1}function X0(n,e){Object.assign(n,{step:n.step+e,seen:0,mean:0,climbed:e<0})}function J0(n,e){return!e&&n<$0?0:Math.max(.25*n,Math.min(n,pT-n-.01))}var ad=1.6;function xT(){let n=document.createElement("canvas").getContext("webgl2"),e=n?.getExtension("WEBGL_debug_renderer_info"),t=e?n.getParameter(e.UNMASKED_RENDERER_WEBGL):"";return n?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)}function K0(n,e=null){let t=e==="plain"||e!=="full"&&xT(),i=new du({canvas:n,antialias:!t,alpha:!0,powerPreference:"high-performance"});i.outputColorSpace=Yn,i.toneMapping=Pa,i.shadowMap.enabled=!0,i.shadowMap.type=hr,i.shadowMap.autoUpdate=!1;let s=new ha,r=new gn;s.add(r);let o={canvas:n,renderer:i,scene:s,root:r,view:pg(),plain:t,lights:Gg(s),ground:Hg(s),radius:1,size:1,object:null,statics:[],ghost:null,force:Zg(),twist:jg(),marks:t0(),rows:a0(),spring:n0(),dirty:!0,options:{wireframe:!1,ghost:!0,contacts:!0,forces:!0,names:!0},wants:()=>{},wanted:new Set,last:null,moved:!0,resized:!0,fence:null,begun:0,rested:0,pace:Y0({step:t?q0:0,fixed:e==="full"})};return r.add(o.force.group,o.twist.group,o.marks.group,o.rows.group,o.spring.group),o.spring.group.visible=!1,o}function j0(n,e,t,i=!1){let s=i?n.last:null;for(let r of Mi(n))n.root.remove(r.group),H0(r);n.ghost&&n.root.remove(n.ghost.group),n.last=null;for(let{group:r}of[n.force,n.twist,n.spring])r.visible=!1;Kf(n.marks,[],[],1,Nt("ring")),ed(n.rows,[],{size:1,longest:1},{near:Nt("contact"),press:Nt("press")}),n.object=nd(t.get(e.object.mesh),e.object),n.statics=e.statics.map(r=>{let o=nd(t.get(r.mesh),r);return Lu(o.group,{position:r.position,quaternion:r.quat_xyzw}),o});for(let r of Mi(n))Ru(r,{wireframe:n.options.wireframe}),sd(r,nl[n.pace.step].rich);n.ghost=Bg(n.object.geometry),Lu(n.object.group,{position:e.start.position,quaternion:e.start.quat_xyzw}),n.root.add(n.object.group,...n.statics.map(r=>r.group),n.ghost.group),n.size=e.object.radius,n.wanted.clear(),i||MT(n),n.moved=!0,Nu(n),s&&Du(n,s)}var Mi=n=>n.object?[n.object,...n.statics]:[];function Q0(n,e){for(let t of Mi(n))t.about.mesh===e.number&&F0(t,e);n.last&&il(n,n.last),n.dirty=n.moved=!0}function e_(n,e){for(let t of Mi(n))t.about.mesh===e.number&&B0(t,e);n.last&&il(n,n.last),n.dirty=n.moved=!0}function t_(n,e,t){Ru(e,{browsed:t}),t!==null&&Iu(n,e,t),n.last&&il(n,n.last),n.dirty=n.moved=!0}var vT=3,yT=1e3;async function Iu(n,e,t){let i=`${e.about.mesh} ${t}`,{wanted:s}=n;if(!U0(e,t)||s.has(i))return;s.add(i),(await n.wants(e.about.mesh,t)).ok||setTimeout(()=>s.delete(i),yT)}function ST(n){let{off:e}=nl[n.pace.step],t=new W,i=!1;for(let s of Mi(n)){let{center:r,radius:o,relief:a}=s.about;n.root.localToWorld(t.set(...r).applyQuaternion(s.group.quaternion).add(s.group.position));let l=Math.max(n.view.camera.near,Xa(n.view,t)-o/n.radius),c=Wa(n.view,l,n.canvas.clientHeight)*n.radius,u=rd(s,c,e-(a??0)/c);if(Iu(n,s,u),i=z0(s,u)||i,s!==n.object)continue;let h=rd(s,c,vT*e);Iu(n,s,h),kg(n.ghost,od(s,h).geometry)}i&&n.last&&il(n,n.last)}function Lu(n,e){n.position.fromArray(e.position),n.quaternion.fromArray(e.quaternion)}function MT(n){let e=[];for(let{group:i,geometry:s}of[n.object,...n.statics]){let r=Wf(s.attributes.position.array);i.updateMatrix();for(let o=0;o<8;o++){let a=[0,1,2].map(l=>o&1<<l?r.max[l]:r.min[l]);e.push(...new W(...a).applyMatrix4(i.matrix).toArray())}}let t=Wf(e);n.radius=t.radius>0?t.radius:1,n.root.scale.setScalar(1/n.radius),n.root.position.fromArray(t.center).multiplyScalar(-1/n.radius),n.ground.position.z=(t.min[2]-t.center[2])/n.radius-.012,n.root.updateMatrixWorld()}function Nu(n){let e=Number(Nt("sky"));if(n.object){id(n.object,{base:Nt("held"),line:Nt("held-line"),sky:e});for(let t of n.statics)id(t,{base:Nt("fixed"),line:Nt("fixed-line"),sky:e});n.ghost.glass.material.uniforms.tone.value.set(Nt("ghost"))}Kg(n.force,Nt("force")),e0(n.twist,Nt("torque")),s0(n.spring,Nt("hand")),n.ground.material.opacity=Number(Nt("shadow")),n.lights.sky.intensity=e,n.dirty=!0}function Du(n,e){if(!n.object)return;n.last=e,Lu(n.object.group,e.object),Lu(n.ghost.group,e.ghost);let t=(e.bits&1)!==0,i=new W(...e.grasp),s=new W(...e.handle.position);n.ghost.group.visible=n.options.ghost&&t&&zg(e,n.size)>.004,n.spring.group.visible=n.options.ghost&&t,i0(n.spring,i,s,.012*n.size),bT(n,e,i),il(n,e),n.dirty=n.moved=!0}function bT(n,e,t){if(!n.options.forces){n.force.group.visible=n.twist.group.visible=!1;return}let i=e.metresPerNewton>0?e.metresPerNewton:.5*n.size,s=new W(...e.force).multiplyScalar(ad*i);s.clampLength(0,4*n.size),Jg(n.force,t,s,.045*n.size);let r=new W(...e.torque),o=.5*n.size*n.size/i;Qg(n.twist,t,r,r.length()/o,.42*n.size)}function il(n,e){let t=(e.bits&yr.constrained)!==0,i=n.options.contacts&&!t?e.contacts:[];ed(n.rows,n.options.contacts?e.rows:[],{size:.045*n.size,longest:.34*n.size},{near:Nt("contact"),press:Nt("press")});let s=Math.max(1e-30,...e.clusters.map(a=>Math.hypot(...a.force)));Kf(n.marks,i.map(a=>({point:a.point,normal:a.normal,level:a.objectLevel})),n.options.contacts?e.clusters.map(a=>({point:a.point,normal:a.normal,share:Math.hypot(...a.force)/s})):[],.011*n.size,Nt("ring"));let r=(a,l)=>{if(G0(a,l.map(({point:c,node:u,level:h})=>({point:wT(a.group,c),node:u,level:h})),n.size),a.wireframe)for(let{level:c}of l)Iu(n,a,c)},o=t&&n.object.about.levels<=1?[]:e.contacts;r(n.object,o.map(a=>({point:a.point,node:a.objectNode,level:a.objectLevel}))),n.statics.forEach((a,l)=>r(a,o.filter(c=>c.body===l).map(c=>({point:c.point,node:c.sceneNode,level:c.sceneLevel}))))}function wT(n,e){return new W(...e).sub(n.position).applyQuaternion(n.quaternion.clone().conjugate()).toArray()}function n_(n,e){Object.assign(n.options,e);for(let t of Mi(n))Ru(t,{wireframe:n.options.wireframe});n.last&&Du(n,n.last),n.dirty=!0}function ld(n){let{clientWidth:e,clientHeight:t}=n.canvas;e===0||t===0||(n.resized=!0,n.view.camera.aspect=e/t,n.view.camera.fov=e<t?38:30,n.view.camera.updateProjectionMatrix(),Ys(n.view))}function TT(n){let{clientWidth:e,clientHeight:t}=n.canvas,{pixels:i,shadows:s,rich:r}=nl[n.pace.step];n.renderer.setPixelRatio(n.plain?1:Math.min(i,devicePixelRatio)),e>0&&t>0&&n.renderer.setSize(e,t,!1),n.lights.key.castShadow=n.ground.visible=s;for(let o of Mi(n))sd(o,r);n.resized=!1,n.moved=!0}function i_(n){let e=n.renderer.getContext(),t=performance.now();if(n.fence&&!e.isContextLost()){if(e.getSyncParameter(n.fence,e.SYNC_STATUS)!==e.SIGNALED)return!1;e.deleteSync(n.fence),n.fence=null;let i=.001*(t-n.begun);n.rested=t+1e3*J0(i,n.plain),n.resized||=Z0(n.pace,i)}return t>=n.rested}function s_(n){if(!(n.dirty||n.view.changed))return!1;let e=n.renderer.getContext();return n.resized&&TT(n),ST(n),n.dirty=n.view.changed=!1,n.renderer.shadowMap.needsUpdate=n.moved,n.moved=!1,n.begun=performance.now(),n.renderer.render(n.scene,n.view.camera),n.fence=e.fenceSync(e.SYNC_GPU_COMMANDS_COMPLETE,0),e.flush(),!0}function r_(n,e){let t=n.root.localToWorld(new W(...e));return 2*Math.tan(n.view.camera.fov*Math.PI/360)*Xa(n.view,t)*n.radius/Math.max(1,n.canvas.clientHeight)}var o_=.008;function a_(n){let{canvas:e}=n.stage,t={player:n,pointers:new Map,mode:null,keys:new Set,touch:matchMedia("(pointer: coarse)").matches};e.addEventListener("contextmenu",i=>i.preventDefault()),e.addEventListener("pointerdown",i=>AT(t,i)),e.addEventListener("pointermove",i=>CT(t,i));for(let i of["pointerup","pointercancel"])e.addEventListener(i,s=>IT(t,s));return e.addEventListener("wheel",i=>LT(t,i),{passive:!1}),addEventListener("keydown",i=>DT(t,i)),addEventListener("keyup",({key:i})=>t.keys.delete(i)),addEventListener("blur",()=>t.keys.clear()),e.addEventListener("dblclick",i=>{i.button===2&&gu(n.stage.view)}),t}function AT(n,e){let{canvas:t}=n.player.stage;t.focus({preventScroll:!0}),t.setPointerCapture(e.pointerId),n.pointers.set(e.pointerId,{x:e.clientX,y:e.clientY}),n.touch=e.pointerType==="touch",n.touch?n.pointers.size===1&&(n.mode=ET(n,e)&&n.player.mayMove()?"hand":"view"):e.button===0?n.mode=n.player.mayMove()?"hand":"view":n.mode=e.button===1||e.shiftKey?"pan":"view",n.mode==="hand"&&n.player.press(),t.classList.toggle("grabbing",n.mode==="hand")}function ET({player:{stage:n}},e){if(!n.object)return!1;let t=n.canvas.getBoundingClientRect(),i=new ut((e.clientX-t.left)/t.width*2-1,1-(e.clientY-t.top)/t.height*2),s=new Ra;return s.setFromCamera(i,n.view.camera),s.intersectObject(n.object.finest.solid,!1).length>0}function CT(n,e){let t=n.pointers.get(e.pointerId);if(t){if(n.pointers.size===2)PT(n,e,t);else{let i=e.getCoalescedEvents?.()??[];for(let s of i.length>0?i:[e])RT(n,s,s.clientX-t.x,s.clientY-t.y),t.x=s.clientX,t.y=s.clientY}t.x=e.clientX,t.y=e.clientY,n.mode==="hand"&&n.player.give()}}function RT(n,e,t,i){let{stage:s}=n.player;if(!(t===0&&i===0)){if(n.mode==="view")return Rf(s.view,t,i);if(n.mode==="pan")return Pf(s.view,t,i,s.canvas.clientHeight);if(n.mode==="hand")return e.ctrlKey||e.altKey||e.metaKey?Uu(n,t,i,0,e.timeStamp):e.shiftKey?Co(n,0,0,-i,e.timeStamp):Co(n,t,i,0,e.timeStamp)}}function Co(n,e,t,i,s){let{stage:r,hand:o}=n.player,a=r_(r,n.player.grasp()),{right:l,up:c,forward:u}=_r(r.view),h=[0,1,2].map(f=>a*(e*l.getComponent(f)-t*c.getComponent(f)+i*u.getComponent(f)));Dg(o,h,n.player.workspace()),Ao(o,s/1e3),n.player.moved(!1)}function Uu(n,e,t,i,s){let{stage:r,hand:o}=n.player,{right:a,up:l,forward:c}=_r(r.view),u=n.player.workspace();Su(o,l.toArray(),o_*e,u),Su(o,a.toArray(),o_*t,u),i!==0&&Su(o,c.toArray(),i,u),Ao(o,s/1e3),n.player.moved(!0)}function PT(n,e,t){let[i]=[...n.pointers].filter(([h])=>h!==e.pointerId).map(([,h])=>h),s={x:t.x-i.x,y:t.y-i.y},r={x:e.clientX-i.x,y:e.clientY-i.y},o=(Math.hypot(r.x,r.y)||1)/(Math.hypot(s.x,s.y)||1),a=Math.atan2(s.x*r.y-s.y*r.x,s.x*r.x+s.y*r.y),l=.5*(e.clientX-t.x),c=.5*(e.clientY-t.y),{stage:u}=n.player;n.mode==="hand"?(Uu(n,l,c,a,e.timeStamp),Co(n,0,0,-200*Math.log(o),e.timeStamp)):(Pf(u.view,l,c,u.canvas.clientHeight),wo(u.view,1/o))}function IT(n,e){n.pointers.delete(e.pointerId),!(n.pointers.size>0)&&(n.mode=null,n.player.stage.canvas.classList.remove("grabbing"))}function LT(n,e){e.preventDefault();let t=e.deltaY*(e.deltaMode===1?16:e.deltaMode===2?400:1);n.mode==="hand"?(Co(n,0,0,-.4*t,e.timeStamp),n.player.give()):wo(n.player.stage.view,Math.exp(.0012*t))}var l_={ArrowLeft:[-1,0,0],ArrowRight:[1,0,0],ArrowUp:[0,-1,0],ArrowDown:[0,1,0],PageUp:[0,0,1],PageDown:[0,0,-1]},NT=160;function DT(n,e){let t=e.target===n.player.stage.canvas||e.target===document.body;!l_[e.key]||!t||(e.preventDefault(),Object.assign(n,{turns:e.ctrlKey||e.altKey||e.metaKey,views:e.shiftKey}),n.keys.add(e.key))}function c_(n,e){if(n.keys.size===0)return;let{hand:t,stage:i}=n.player,s=NT*Math.min(.1,e),[r,o,a]=[0,1,2].map(l=>s*[...n.keys].reduce((c,u)=>c+l_[u][l],0));!t.clutch||n.views?(Rf(i.view,r,o),a!==0&&wo(i.view,Math.exp(-.004*a))):n.turns?Uu(n,r,o,.01*a,performance.now()):Co(n,r,o,a,performance.now()),n.player.give()}var UT=.12;function u_(n,e,t,i){let s=[...navigator.getGamepads?.()??[]].find(a=>a?.connected);if(!s)return!1;let{player:r}=n,o=a=>Math.abs(s.axes[a]??0)>UT?s.axes[a]:0;if(s.buttons[0]?.pressed&&r.mayMove()&&r.press(),s.buttons[1]?.pressed&&r.letGo(),r.hand.clutch){let a=220*Math.min(.1,e),l=(s.buttons[7]?.value??0)-(s.buttons[6]?.value??0);(o(0)||o(1)||l)&&Co(n,a*o(0),a*o(1),a*l,performance.now()),(o(2)||o(3))&&Uu(n,a*o(2),a*o(3),0,performance.now())}return FT(n,s,Math.min(1,t/i)),!0}function FT(n,e,t){let i=performance.now();!e.vibrationActuator?.playEffect||t<.02||i-(n.rumbled??-1e9)<60||(n.rumbled=i,e.vibrationActuator.playEffect("dual-rumble",{duration:80,strongMagnitude:t,weakMagnitude:.5*t}).catch(()=>{}))}function h_(n,e){let t={url:n,on:e,worker:new Worker("worker.js"),isOpen:!1,attempt:0,nextId:1,asked:new Map,received:0,bytes:0,posted:0,gone:0,stopped:!1};return t.worker.onmessage=({data:i})=>OT(t,i),t.worker.onerror=()=>g_(t,"The page could not start its worker. Reload the page."),t.worker.postMessage({open:n,origin:performance.timeOrigin}),t}function OT(n,e){if(!n.stopped)if(e.data!==void 0)try{BT(n,e.data)}finally{n.worker.postMessage({taken:1})}else e.opened?(Object.assign(n,{isOpen:!0,attempt:0}),n.on.opened()):e.lost?__(n,e.lost):e.gone!==void 0&&(n.gone=e.gone)}function BT(n,e){if(!n.isOpen)return;n.received+=1,n.bytes+=typeof e=="string"?e.length:e.byteLength;let t=null;try{t=typeof e=="string"?Rg(e):Cg(e)}catch(i){if(!(i instanceof Ya))throw i;g_(n,`The program says something this page does not understand: ${i.message}. Reload the page.`);return}t.type==="ack"&&kT(n,t),n.on.message(t)}function kT(n,e){let t=n.asked.get(e.id);n.asked.delete(e.id),t?.(e)}function Tr(n,e){if(!n.isOpen)return Promise.resolve({ok:!1,reason:"The program is not connected."});let t=n.nextId;return n.nextId=t===2147483647?1:t+1,n.worker.postMessage({text:JSON.stringify({...e,id:t})}),new Promise(i=>n.asked.set(t,i))}function f_(n,e){n.isOpen&&e.length>0&&n.worker.postMessage({hand:e})}var d_=n=>n?.worker.postMessage({letGo:!0});function p_(n,e){return n.isOpen?(n.posted+=e.byteLength,n.worker.postMessage({bytes:e},[e]),!0):!1}var m_=n=>Math.max(0,n.posted-n.gone);function g_(n,e){n.stopped=!0,n.worker.postMessage({stop:!0}),__(n,e)}function __(n,e){Object.assign(n,{isOpen:!1,posted:0,gone:0,attempt:n.attempt+1});for(let t of n.asked.values())t({ok:!1,reason:"The connection was lost."});n.asked.clear(),n.on.lost(e)}function At(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}function zT({min:n,max:e,scale:t},i){let s=t==="log"?Math.log(i/n)/Math.log(e/n):(i-n)/(e-n);return Math.max(0,Math.min(1,s))}function x_({min:n,max:e,scale:t},i){return t==="log"?n*(e/n)**i:n+i*(e-n)}var sl=n=>String(Number(n.toPrecision(3)));function v_(n,e){return{parent:n,ask:e,rows:new Map}}function y_(n,e){let t=new Set(e.map(i=>i.name));for(let[i,s]of n.rows)t.has(i)||(s.box.remove(),n.rows.delete(i));for(let i of e)n.rows.has(i.name)||n.rows.set(i.name,GT(n,i)),HT(n.rows.get(i.name),i)}function VT(n,e){let t=At("div","parameter"),i=At("div","parameter-top"),s=At("span","words"),r=At("label","",e.label),o=At("p","note"),a=At("p","refusal"),l=At("p","warning");a.setAttribute("role","alert"),s.setAttribute("role","radiogroup"),s.setAttribute("aria-label",e.label);let c=e.choices.map((h,f)=>{let p=Object.assign(At("button","chip-button",h),{type:"button"});return p.setAttribute("role","radio"),p.addEventListener("click",()=>{u.parameter.value!==f&&rl(n,u,f)}),s.append(p),p});i.append(r,s),t.append(i,o,a,l),n.parent.append(t);let u={box:t,buttons:c,help:o,refusal:a,warning:l,parameter:e,busy:!1,next:null};return u}function GT(n,e){if(e.kind==="choice")return VT(n,e);let t=At("div","parameter"),i=At("label","",e.label),s=Object.assign(At("input"),{type:"range",min:0,max:1,step:.001,id:`parameter-${e.name}`});i.htmlFor=s.id;let r=Object.assign(At("input","value"),{type:"text",inputMode:"decimal"});r.setAttribute("aria-label",`${e.label}, ${e.unit}`);let o=At("span","unit",e.unit),a=At("p","note"),l=At("p","refusal");l.setAttribute("role","alert");let c=At("div","parameter-top"),u=At("p","warning"),h={box:t,slider:s,number:r,help:a,refusal:l,warning:u,parameter:e,busy:!1,next:null,on:null};return e.kind==="optional"&&(h.on=Object.assign(At("input","switch"),{type:"checkbox"}),h.on.setAttribute("aria-label",`${e.label} on`),h.kept=e.value||x_(e,.5),h.on.addEventListener("change",()=>rl(n,h,h.on.checked?Number(sl(h.kept)):0)),c.append(h.on)),c.append(i,r,o),t.append(c,s,a,l,u),n.parent.append(t),s.addEventListener("input",()=>{let f=Number(sl(x_(h.parameter,Number(s.value))));r.value=sl(f),rl(n,h,f)}),r.addEventListener("change",()=>{let f=Number(r.value.replace(",","."));r.value.trim()!==""&&Number.isFinite(f)?rl(n,h,f):S_(h,`"${r.value}" is not a number.`)}),h}async function rl(n,e,t){if(e.busy){e.next=t;return}e.busy=!0;let i=await n.ask(e.parameter.name,t);if(e.busy=!1,e.next!==null){let s=e.next;e.next=null,rl(n,e,s);return}if(!i.ok){S_(e,i.reason??"Refused.");return}e.refusal.textContent="",e.parameter={...e.parameter,value:i.value??t},cd(e),e.box.classList.remove("changed"),e.box.offsetWidth,e.box.classList.add("changed")}function S_(n,e){let{value:t,unit:i,choices:s}=n.parameter,r=s?.length>0?s[t]:n.on&&t===0?"off":`${sl(t)} ${i}`.trim();n.refusal.textContent=`${e.replace(/[.]?$/,".")} It stays at ${r}.`,cd(n)}function HT(n,e){n.parameter=e;let t=e.begins_again?" Begins again.":"";n.help.textContent=e.locked??`${e.help??""}${t}`,n.warning.textContent=e.warning?`Risky: ${e.warning}.`:"";let i=!!e.locked;n.box.classList.toggle("locked",i);for(let s of[n.slider,n.number,n.on,...n.buttons??[]])s&&(s.disabled=i);!n.busy&&document.activeElement!==n.number&&cd(n)}function cd(n){let{value:e}=n.parameter;if(n.buttons?.forEach((i,s)=>i.setAttribute("aria-checked",String(s===e))),n.buttons)return;let t=n.on!==null&&e===0;n.on&&(n.on.checked=!t,t||(n.kept=e),n.box.classList.toggle("off",t)),n.slider.value=zT(n.parameter,t?n.kept:e),n.number.value=t?"off":sl(e)}var WT=200;function M_(n,e){let t=At("div",`event ${e.kind}`);for(t.append(At("time","",`${Zs(e.time)} s`),At("span","",vu(e))),n.prepend(t);n.childElementCount>WT;)n.lastChild.remove()}var XT=[["Drag","moves the hand in the plane of the screen"],["Wheel while dragging, or Shift + drag","moves it away from you and back"],["Ctrl or Alt + drag","turns it"],["Space","lets go, or takes hold"],["Arrow keys, Page up and down","move the hand that holds, on the picture; with Ctrl or Alt they turn it, with Shift the view"],["Right drag, wheel","turns and zooms the view; middle drag shifts it"],["Touch","one finger on the object moves it, a second turns and lifts it; beside it fingers move the view"],["Gamepad","sticks move and turn, triggers push and pull, A holds, B lets go; it rumbles with the force"],["P . R O","pause, one step, begin again, open a scene"],["F L G C A N","fit the view; levels of detail, ghost, contacts, arrows, names on and off"],["S","sound of contact on and off: changes of the force"],["1 to 6, + -","look along the axes, as the buttons of the compass do; nearer and farther"]];function b_(n){let e=At("h2","","The mouse is the hand"),t=At("p","lead","Drag the blue object: the ghost shows where your hand is, the object where it may be, and the line between them, as long as the force is strong, is what a haptic device would let you feel."),i=At("dl");for(let[o,a]of XT){let l=/^(Drag|Touch|Gamepad)$/.test(o)?"":"for-mouse";i.append(At("dt",l,o),At("dd",l,a))}let s=At("p","note");s.append(Ro("force","force on the hand"),Ro("torque","torque, turning along the arc"),Ro("ring","clusters of contacts"),Ro("levels","dots: contacts with their normals, in the colour of their level of detail"),Ro("contact","under constraints, discs: planes that the object keeps off, with the points they keep off"),Ro("press","those that press, with their force and the cone it may lie in"));let r=Object.assign(At("button","primary","Close"),{type:"button"});r.addEventListener("click",()=>n.close()),n.addEventListener("click",o=>{o.target===n&&n.close()}),n.replaceChildren(e,t,i,s,r)}function Ro(n,e){let t=At("span",`key ${n}`,e);return t.prepend(At("i")),t}var qT="uplot",$T="u-hz",YT="u-vt",ZT="u-title",JT="u-wrap",KT="u-under",jT="u-over",QT="u-axis",Cr="u-off",eA="u-select",tA="u-cursor-x",nA="u-cursor-y",iA="u-cursor-pt",sA="u-legend",rA="u-live",oA="u-inline",aA="u-series",lA="u-marker",w_="u-label",cA="u-value",al="width",ll="height";var T_="bottom",Po="left",ud="right",Ed="#000",A_=Ed+"0",hd="mousemove",E_="mousedown",fd="mouseup",C_="mouseenter",R_="mouseleave",P_="dblclick",uA="resize",hA="scroll",I_="change",zu="dppxchange",Cd="--",Oo=typeof window<"u",_d=Oo?document:null,Lo=Oo?window:null,fA=Oo?navigator:null,wt,Fu;function xd(){let n=devicePixelRatio;wt!=n&&(wt=n,Fu&&yd(I_,Fu,xd),Fu=matchMedia(`(min-resolution: ${wt-.001}dppx) and (max-resolution: ${wt+.001}dppx)`),Rr(I_,Fu,xd),Lo.dispatchEvent(new CustomEvent(zu)))}function di(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function vd(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Xt(n,e,t){n.style[e]=t+"px"}function ki(n,e,t,i){let s=_d.createElement(n);return e!=null&&di(s,e),t?.insertBefore(s,i),s}function bi(n,e){return ki("div",n,e)}var L_=new WeakMap;function ss(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=L_.get(n);r!=o&&(n.style.transform=r,L_.set(n,r),e<0||t<0||e>i||t>s?di(n,Cr):vd(n,Cr))}var N_=new WeakMap;function D_(n,e,t){let i=e+t,s=N_.get(n);i!=s&&(N_.set(n,i),n.style.background=e,n.style.borderColor=t)}var U_=new WeakMap;function F_(n,e,t,i){let s=e+""+t,r=U_.get(n);s!=r&&(U_.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Rd={passive:!0},dA={...Rd,capture:!0};function Rr(n,e,t,i){e.addEventListener(n,t,i?dA:Rd)}function yd(n,e,t,i){e.removeEventListener(n,t,Rd)}Oo&&xd();function zi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:pi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function ux(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var hx=n=>n!=null,fx=n=>n!=null&&n>0,Hu=ux(hx),pA=ux(fx);function mA(n,e,t,i=0,s=!1){let r=s?pA:Hu,o=s?fx:hx;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ut,l??-Ut]}function Wu(n,e,t,i){let s=k_(n),r=k_(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?As:dx,a=s==1?pi:wi,l=r==1?wi:pi,c=a(o(wn(n))),u=l(o(wn(e))),h=No(t,c),f=No(t,u);return t==10&&(c<0&&(h=Ft(h,-c)),u<0&&(f=Ft(f,-u))),i||t==2?(n=h*s,e=f*r):(n=_x(n,h),e=Xu(e,f)),[n,e]}function Pd(n,e,t,i){let s=Wu(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Id=.1,O_={mode:3,pad:Id},ul={pad:0,soft:null,mode:0},gA={min:ul,max:ul};function Vu(n,e,t,i){return qu(t)?B_(n,e,t):(ul.pad=t,ul.soft=i?0:null,ul.mode=i?3:0,B_(n,e,gA))}function Mt(n,e){return n??e}function _A(n,e,t){for(e=Mt(e,0),t=Mt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function B_(n,e,t){let i=t.min,s=t.max,r=Mt(i.pad,0),o=Mt(s.pad,0),a=Mt(i.hard,-Ut),l=Mt(s.hard,Ut),c=Mt(i.soft,Ut),u=Mt(s.soft,-Ut),h=Mt(i.mode,0),f=Mt(s.mode,0),p=e-n,g=As(p),v=jn(wn(n),wn(e)),d=As(v),m=wn(d-g);(p<1e-24||m>10)&&(p=0,(n==0||e==0)&&(p=1e-24,h==2&&c!=Ut&&(r=0),f==2&&u!=-Ut&&(o=0)));let y=p||v||1e3,C=As(y),b=No(10,pi(C)),P=y*(p==0?n==0?.1:1:r),A=Ft(_x(n-P,b/10),24),x=n>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:Ut,T=jn(a,A<x&&n>=x?x:Vi(x,A)),B=y*(p==0?e==0?.1:1:o),D=Ft(Xu(e+B,b/10),24),I=e<=u&&(f==1||f==3&&D>=u||f==2&&D<=u)?u:-Ut,k=Vi(l,D>I&&e<=I?I:jn(I,D));return T==k&&T==0&&(k=100),[T,k]}var xA=new Intl.NumberFormat(Oo?fA.language:"en-US"),Ld=n=>xA.format(n),mi=Math,ku=mi.PI,wn=mi.abs,pi=mi.floor,bn=mi.round,wi=mi.ceil,Vi=mi.min,jn=mi.max,No=mi.pow,k_=mi.sign,As=mi.log10,dx=mi.log2,vA=(n,e=1)=>mi.sinh(n)*e,dd=(n,e=1)=>mi.asinh(n/e),Ut=1/0;function z_(n){return(As((n^n>>31)-(n>>31))|0)+1}function Sd(n,e,t){return Vi(jn(n,e),t)}function px(n){return typeof n=="function"}function _t(n){return px(n)?n:()=>n}var yA=()=>{},mx=n=>n,gx=(n,e)=>e,SA=n=>null,V_=n=>!0,G_=(n,e)=>n==e,MA=/\.\d*?(?=9{6,}|0{6,})/gm,Pr=n=>{if(vx(n)||er.has(n))return n;let e=`${n}`,t=e.match(MA);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Pr(s)}e${r}`}return Ft(n,i)};function Ar(n,e){return Pr(Ft(Pr(n/e))*e)}function Xu(n,e){return Pr(wi(Pr(n/e))*e)}function _x(n,e){return Pr(pi(Pr(n/e))*e)}function Ft(n,e=0){if(vx(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return bn(i)/t}var er=new Map;function xx(n){return((""+n).split(".")[1]||"").length}function fl(n,e,t,i){let s=[],r=i.map(xx);for(let o=e;o<t;o++){let a=wn(o),l=Ft(No(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:Ft(u,h);s.push(f),er.set(f,h)}}return s}var hl={},Nd=[],Do=[null,null],Qs=Array.isArray,vx=Number.isInteger,bA=n=>n===void 0;function H_(n){return typeof n=="string"}function qu(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function wA(n){return n!=null&&typeof n=="object"}var TA=Object.getPrototypeOf(Uint8Array),yx="__proto__";function Uo(n,e=qu){let t;if(Qs(n)){let i=n.find(s=>s!=null);if(Qs(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Uo(n[s],e)}else t=n.slice()}else if(n instanceof TA)t=n.slice();else if(e(n)){t={};for(let i in n)i!=yx&&(t[i]=Uo(n[i],e))}else t=n;return t}function xn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=yx&&(qu(n[s])?xn(n[s],Uo(i[s])):n[s]=Uo(i[s]))}return n}var AA=0,EA=1,CA=2;function RA(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function PA(n,e){if(NA(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return DA(o[0])||(o=LA(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:EA,p=[];for(let g=0;g<u.length;g++){let v=u[g],d=r.get(l[g]);v===null?f!=AA&&(h[d]=v,f==CA&&p.push(d)):h[d]=v}RA(h,p,s),i.push(h)}}return i}var IA=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function LA(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function NA(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function DA(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=jn(1,pi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Sx=["January","February","March","April","May","June","July","August","September","October","November","December"],Mx=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function bx(n){return n.slice(0,3)}var UA=Mx.map(bx),FA=Sx.map(bx),OA={MMMM:Sx,MMM:FA,WWWW:Mx,WWW:UA};function ol(n){return(n<10?"0":"")+n}function BA(n){return(n<10?"00":n<100?"0":"")+n}var kA={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>ol(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ol(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>ol(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ol(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ol(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>BA(n.getMilliseconds())};function Dd(n,e){e=e||OA;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?kA[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var zA=new Intl.DateTimeFormat().resolvedOptions().timeZone;function VA(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==zA?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var wx=n=>n%1==0,Gu=[1,2,2.5,5],GA=fl(10,-32,0,Gu),Tx=fl(10,0,32,Gu),HA=Tx.filter(wx),Er=GA.concat(Tx),Ud=`
`,Ax="{YYYY}",W_=Ud+Ax,Ex="{M}/{D}",cl=Ud+Ex,Ou=cl+"/{YY}",Cx="{aa}",WA="{h}:{mm}",Io=WA+Cx,X_=Ud+Io,q_=":{ss}",Et=null;function Rx(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?fl(10,0,3,Gu).filter(wx):fl(10,-3,0,Gu)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Ax,Et,Et,Et,Et,Et,Et,1],[s*28,"{MMM}",W_,Et,Et,Et,Et,Et,1],[s,Ex,W_,Et,Et,Et,Et,Et,1],[i,"{h}"+Cx,Ou,Et,cl,Et,Et,Et,1],[t,Io,Ou,Et,cl,Et,Et,Et,1],[e,q_,Ou+" "+Io,Et,cl+" "+Io,Et,X_,Et,1],[n,q_+".{fff}",Ou+" "+Io,Et,cl+" "+Io,Et,X_,Et,1]];function u(h){return(f,p,g,v,d,m)=>{let y=[],C=d>=o,b=d>=r&&d<o,P=h(g),A=Ft(P*n,3),x=pd(P.getFullYear(),C?0:P.getMonth(),b||C?1:P.getDate()),T=Ft(x*n,3);if(b||C){let B=b?d/r:0,D=C?d/o:0,I=A==T?A:Ft(pd(x.getFullYear()+D,x.getMonth()+B,1)*n,3),k=new Date(bn(I/n)),V=k.getFullYear(),N=k.getMonth();for(let H=0;I<=v;H++){let $=pd(V+D*H,N+B*H,1),G=$-h(Ft($*n,3));I=Ft((+$+G)*n,3),I<=v&&y.push(I)}}else{let B=d>=s?s:d,D=pi(g)-pi(A),I=T+D+Xu(A-T,B);y.push(I);let k=h(I),V=k.getHours()+k.getMinutes()/t+k.getSeconds()/i,N=d/i,H=f.axes[p]._space,$=m/H;for(;I=Ft(I+d,n==1?0:3),!(I>v);)if(N>1){let G=pi(Ft(V+N,6))%24,j=h(I).getHours()-G;j>1&&(j=-1),I-=j*i,V=(V+N)%24;let ie=y[y.length-1];Ft((I-ie)/d,3)*$>=.7&&y.push(I)}else y.push(I)}return y}}return[l,c,u]}var[XA,qA,$A]=Rx(1),[YA,ZA,JA]=Rx(.001);fl(2,-53,53,[1]);function $_(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Y_(n,e){return(t,i,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,u,h,f,p;return i.map(g=>{let v=n(g),d=v.getFullYear(),m=v.getMonth(),y=v.getDate(),C=v.getHours(),b=v.getMinutes(),P=v.getSeconds(),A=d!=l&&a[2]||m!=c&&a[3]||y!=u&&a[4]||C!=h&&a[5]||b!=f&&a[6]||P!=p&&a[7]||a[1];return l=d,c=m,u=y,h=C,f=b,p=P,A(v)})}}function KA(n,e){let t=Dd(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function pd(n,e,t){return new Date(n,e,t)}function Z_(n,e){return e(n)}var jA="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function J_(n,e){return(t,i,s,r)=>r==null?Cd:e(n(i))}function QA(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function eE(n,e){return n.series[e].fill(n,e)}var tE={show:!0,live:!0,isolate:!1,mount:yA,markers:{show:!0,width:2,stroke:QA,fill:eE,dash:"solid"},idx:null,idxs:null,values:[]};function nE(n,e){let t=n.cursor.points,i=bi(),s=t.size(n,e);Xt(i,al,s),Xt(i,ll,s);let r=s/-2;Xt(i,"marginLeft",r),Xt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Xt(i,"borderWidth",o),i}function iE(n,e){let t=n.series[e].points;return t._fill||t._stroke}function sE(n,e){let t=n.series[e].points;return t._stroke||t._fill}function rE(n,e){return n.series[e].points.size}var md=[0,0];function oE(n,e,t){return md[0]=e,md[1]=t,md}function Bu(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function gd(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var aE={show:!0,x:!0,y:!0,lock:!1,move:oE,points:{one:!1,show:nE,size:rE,width:0,stroke:sE,fill:iE},bind:{mousedown:Bu,mouseup:Bu,click:Bu,dblclick:Bu,mousemove:gd,mouseleave:gd,mouseenter:gd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Px={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Fd=xn({},Px,{filter:gx}),Ix=xn({},Fd,{size:10}),Lx=xn({},Px,{show:!1}),Od='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Nx="bold "+Od,Dx=1.5,K_={show:!0,scale:"x",stroke:Ed,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Nx,side:2,grid:Fd,ticks:Ix,border:Lx,font:Od,lineGap:Dx,rotate:0},lE="Value",cE="Time",j_={show:!0,scale:"x",auto:!1,sorted:1,min:Ut,max:-Ut,idxs:[]};function uE(n,e,t,i,s){return e.map(r=>r==null?"":Ld(r))}function hE(n,e,t,i,s,r,o){let a=[],l=er.get(s)||0;t=o?t:Ft(Xu(t,s),l);for(let c=t;c<=i;c=Ft(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Md(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?As:dx,u=pi(c(t));s=No(l,u),l==10&&(s=Er[zi(s,Er)]);let h=t,f=s*l;l==10&&(f=Er[zi(f,Er)]);do a.push(h),h=h+s,l==10&&!er.has(h)&&(h=Ft(h,er.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Er[zi(f,Er)]));while(h<=i);return a}function fE(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Md(n,e,jn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Md(n,e,jn(l,-i),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var Ux=/./,dE=/[12357]/,pE=/[125]/,Q_=/1/,bd=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function mE(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Ux:l(7,o)-u>=c?dE:l(5,o)-u>=c?pE:Q_;if(h==Q_){let f=wn(l(1,o)-u);if(f<c)return bd(e.slice().reverse(),a.distr,h,wi(c/f)).reverse()}return bd(e,a.distr,h,1)}function gE(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=wn(l(1,o)-l(2,o));return c<a?bd(e.slice().reverse(),3,Ux,wi(a/c)).reverse():e}function _E(n,e,t,i){return i==null?Cd:e==null?"":Ld(e)}var ex={show:!0,scale:"y",stroke:Ed,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Nx,side:3,grid:Fd,ticks:Ix,border:Lx,font:Od,lineGap:Dx,rotate:0};function xE(n,e){let t=3+(n||1)*2;return Ft(t*e,3)}function vE(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=wn(o-r),l=n.series[e],c=a/(l.points.space*wt);return i[1]-i[0]<=c}var tx={scale:null,auto:!0,sorted:0,min:Ut,max:-Ut},Fx=(n,e,t,i,s)=>s,nx={show:!0,auto:!0,sorted:0,gaps:Fx,alpha:1,facets:[xn({},tx,{scale:"x"}),xn({},tx,{scale:"y"})]},ix={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Fx,alpha:1,points:{show:vE,filter:null},values:null,min:Ut,max:-Ut,idxs:[],path:null,clip:null};function yE(n,e,t,i,s){return t/10}var Ox={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},SE=xn({},Ox,{time:!1,ori:1}),sx={};function Bx(n,e){let t=sx[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(sx[n]=t)),t}var Fo=1,wd=2;function Ir(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,p=a.top,g=a.width,v=a.height,d=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,h,d,m,f,p,g,v,Yu,Bo,Ju,zx,Gx):t(s,l,c,u,h,m,d,p,f,v,g,Zu,ko,zd,Vx,Hx)}function Bd(n,e){let t=0,i=0,s=Mt(n.bands,Nd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function ME(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Es(n,e,t,i,s,r){return Ir(n,e,(o,a,l,c,u,h,f,p,g,v,d)=>{let m=o.pxRound,y=c.dir*(c.ori==0?1:-1),C=c.ori==0?Bo:ko,b,P;y==1?(b=t,P=i):(b=i,P=t);let A=m(h(a[b],c,v,p)),x=m(f(l[b],u,d,g)),T=m(h(a[P],c,v,p)),B=m(f(r==1?u.max:u.min,u,d,g)),D=new Path2D(s);return C(D,T,B),C(D,A,B),C(D,A,x),D})}function $u(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Ju:zd,l=t;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let p=f[0]-l;p>0&&a(o,l,i,p,i+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function bE(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function kd(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let p=r(n[h]),g=f==h?p:r(n[f]),v=h-s;p=o<=0&&v>=0&&v<l?r(n[v]):p;let m=f+s;g=o>=0&&m>=0&&m<l?r(n[m]):g,g>=p&&a.push([p,g])}return a}function rx(n){return n==0?mx:n==1?bn:e=>Ar(e,n)}function kx(n){let e=n==0?Yu:Zu,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Vi(c,a/2,l/2),u=Vi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Yu=(n,e,t)=>{n.moveTo(e,t)},Zu=(n,e,t)=>{n.moveTo(t,e)},Bo=(n,e,t)=>{n.lineTo(e,t)},ko=(n,e,t)=>{n.lineTo(t,e)},Ju=kx(0),zd=kx(1),zx=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},Vx=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Gx=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Hx=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Wx(n){return(e,t,i,s,r)=>Ir(e,t,(o,a,l,c,u,h,f,p,g,v,d)=>{let{pxRound:m,points:y}=o,C,b;c.ori==0?(C=Yu,b=zx):(C=Zu,b=Vx);let P=Ft(y.width*wt,3),A=(y.size-y.width)/2*wt,x=Ft(A*2,3),T=new Path2D,B=new Path2D,{left:D,top:I,width:k,height:V}=e.bbox;Ju(B,D-x,I-x,k+x*2,V+x*2);let N=H=>{if(l[H]!=null){let $=m(h(a[H],c,v,p)),G=m(f(l[H],u,d,g));C(T,$+A,G),b(T,$,G,A,0,ku*2)}};if(r)r.forEach(N);else for(let H=i;H<=s;H++)N(H);return{stroke:P>0?T:null,fill:T,clip:B,flags:Fo|wd}})}function Xx(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var wE=Xx(Bo),TE=Xx(ko);function qx(n){let e=Mt(n?.alignGaps,0);return(t,i,s,r)=>Ir(t,i,(o,a,l,c,u,h,f,p,g,v,d)=>{[s,r]=Hu(l,s,r);let m=o.pxRound,y=V=>m(h(V,c,v,p)),C=V=>m(f(V,u,d,g)),b,P;c.ori==0?(b=Bo,P=wE):(b=ko,P=TE);let A=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},T=x.stroke,B=!1;if(r-s>=v*4){let V=ue=>t.posToVal(ue,c.key,!0),N=null,H=null,$,G,le,J=y(a[A==1?s:r]),j=y(a[s]),ie=y(a[r]),fe=V(A==1?j+1:ie-1);for(let ue=A==1?s:r;ue>=s&&ue<=r;ue+=A){let Q=a[ue],xe=(A==1?Q<fe:Q>fe)?J:y(Q),Ee=l[ue];xe==J?Ee!=null?(G=Ee,N==null?(b(T,xe,C(G)),$=N=H=G):G<N?N=G:G>H&&(H=G)):Ee===null&&(B=!0):(N!=null&&P(T,J,C(N),C(H),C($),C(G)),Ee!=null?(G=Ee,b(T,xe,C(G)),N=H=$=G):(N=H=null,Ee===null&&(B=!0)),J=xe,fe=V(J+A))}N!=null&&N!=H&&le!=J&&P(T,J,C(N),C(H),C($),C(G))}else for(let V=A==1?s:r;V>=s&&V<=r;V+=A){let N=l[V];N===null?B=!0:N!=null&&b(T,y(a[V]),C(N))}let[I,k]=Bd(t,i);if(o.fill!=null||I!=0){let V=x.fill=new Path2D(T),N=o.fillTo(t,i,o.min,o.max,I),H=C(N),$=y(a[s]),G=y(a[r]);A==-1&&([G,$]=[$,G]),b(V,G,H),b(V,$,H)}if(!o.spanGaps){let V=[];B&&V.push(...kd(a,l,s,r,A,y,e)),x.gaps=V=o.gaps(t,i,s,r,V),x.clip=$u(V,c.ori,p,g,v,d)}return k!=0&&(x.band=k==2?[Es(t,i,s,r,T,-1),Es(t,i,s,r,T,1)]:Es(t,i,s,r,T,k)),x})}function AE(n){let e=Mt(n.align,1),t=Mt(n.ascDesc,!1),i=Mt(n.alignGaps,0),s=Mt(n.extend,!1);return(r,o,a,l)=>Ir(r,o,(c,u,h,f,p,g,v,d,m,y,C)=>{[a,l]=Hu(h,a,l);let b=c.pxRound,{left:P,width:A}=r.bbox,x=j=>b(g(j,f,y,d)),T=j=>b(v(j,p,C,m)),B=f.ori==0?Bo:ko,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},I=D.stroke,k=f.dir*(f.ori==0?1:-1),V=T(h[k==1?a:l]),N=x(u[k==1?a:l]),H=N,$=N;s&&e==-1&&($=P,B(I,$,V)),B(I,N,V);for(let j=k==1?a:l;j>=a&&j<=l;j+=k){let ie=h[j];if(ie==null)continue;let fe=x(u[j]),ue=T(ie);e==1?B(I,fe,V):B(I,H,ue),B(I,fe,ue),V=ue,H=fe}let G=H;s&&e==1&&(G=P+A,B(I,G,V));let[le,J]=Bd(r,o);if(c.fill!=null||le!=0){let j=D.fill=new Path2D(I),ie=c.fillTo(r,o,c.min,c.max,le),fe=T(ie);B(j,G,fe),B(j,$,fe)}if(!c.spanGaps){let j=[];j.push(...kd(u,h,a,l,k,x,i));let ie=c.width*wt/2,fe=t||e==1?ie:-ie,ue=t||e==-1?-ie:ie;j.forEach(Q=>{Q[0]+=fe,Q[1]+=ue}),D.gaps=j=c.gaps(r,o,a,l,j),D.clip=$u(j,f.ori,d,m,y,C)}return J!=0&&(D.band=J==2?[Es(r,o,a,l,I,-1),Es(r,o,a,l,I,1)]:Es(r,o,a,l,I,J)),D})}function ox(n,e,t,i,s,r,o=Ut){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=wn(n[l]-n[a]);u<c&&(c=u,o=wn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function EE(n){n=n||hl;let e=Mt(n.size,[.6,Ut,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=_t(s),o=1-e[0],a=Mt(e[1],Ut),l=Mt(e[2],1),c=Mt(n.disp,hl),u=Mt(n.each,p=>{}),{fill:h,stroke:f}=c;return(p,g,v,d)=>Ir(p,g,(m,y,C,b,P,A,x,T,B,D,I)=>{let k=m.pxRound,V=t,N=i*wt,H=a*wt,$=l*wt,G,le;b.ori==0?[G,le]=r(p,g):[le,G]=r(p,g);let J=b.dir*(b.ori==0?1:-1),j=b.ori==0?Ju:zd,ie=b.ori==0?u:(Re,$e,st,be,Dt,ze,qe)=>{u(Re,$e,st,Dt,be,qe,ze)},fe=Mt(p.bands,Nd).find(Re=>Re.series[0]==g),ue=fe!=null?fe.dir:0,Q=m.fillTo(p,g,m.min,m.max,ue),me=k(x(Q,P,I,B)),xe,Ee,Me,He=D,it=k(m.width*wt),Ve=!1,ct=null,ot=null,tt=null,$t=null;h!=null&&(it==0||f!=null)&&(Ve=!0,ct=h.values(p,g,v,d),ot=new Map,new Set(ct).forEach(Re=>{Re!=null&&ot.set(Re,new Path2D)}),it>0&&(tt=f.values(p,g,v,d),$t=new Map,new Set(tt).forEach(Re=>{Re!=null&&$t.set(Re,new Path2D)})));let{x0:Ot,size:cn}=c;if(Ot!=null&&cn!=null){V=1,y=Ot.values(p,g,v,d),Ot.unit==2&&(y=y.map(st=>p.posToVal(T+st*D,b.key,!0)));let Re=cn.values(p,g,v,d);cn.unit==2?Ee=Re[0]*D:Ee=A(Re[0],b,D,T)-A(0,b,D,T),He=ox(y,C,A,b,D,T,He),Me=He-Ee+N}else He=ox(y,C,A,b,D,T,He),Me=He*o+N,Ee=He-Me;Me<1&&(Me=0),it>=Ee/2&&(it=0),Me<5&&(k=mx);let It=Me>0,Tn=He-Me-(It?it:0);Ee=k(Sd(Tn,$,H)),xe=(V==0?Ee/2:V==J?0:Ee)-V*J*((V==0?N/2:0)+(It?it/2:0));let vt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},vn=Ve?null:new Path2D,jt=null;if(fe!=null)jt=p.data[fe.series[1]];else{let{y0:Re,y1:$e}=c;Re!=null&&$e!=null&&(C=$e.values(p,g,v,d),jt=Re.values(p,g,v,d))}let un=G*Ee,F=le*Ee;for(let Re=J==1?v:d;Re>=v&&Re<=d;Re+=J){let $e=C[Re];if($e==null)continue;if(jt!=null){let X=jt[Re]??0;if($e-X==0)continue;me=x(X,P,I,B)}let st=b.distr!=2||c!=null?y[Re]:Re,be=A(st,b,D,T),Dt=x(Mt($e,Q),P,I,B),ze=k(be-xe),qe=k(jn(Dt,me)),E=k(Vi(Dt,me)),S=qe-E;if($e!=null){let X=$e<0?F:un,ce=$e<0?un:F;Ve?(it>0&&tt[Re]!=null&&j($t.get(tt[Re]),ze,E+pi(it/2),Ee,jn(0,S-it),X,ce),ct[Re]!=null&&j(ot.get(ct[Re]),ze,E+pi(it/2),Ee,jn(0,S-it),X,ce)):j(vn,ze,E+pi(it/2),Ee,jn(0,S-it),X,ce),ie(p,g,Re,ze-it/2,E,Ee+it,S)}}return it>0?vt.stroke=Ve?$t:vn:Ve||(vt._fill=m.width==0?m._fill:m._stroke??m._fill,vt.width=0),vt.fill=Ve?ot:vn,vt})}function CE(n,e){let t=Mt(e?.alignGaps,0);return(i,s,r,o)=>Ir(i,s,(a,l,c,u,h,f,p,g,v,d,m)=>{[r,o]=Hu(c,r,o);let y=a.pxRound,C=G=>y(f(G,u,d,g)),b=G=>y(p(G,h,m,v)),P,A,x;u.ori==0?(P=Yu,x=Bo,A=Gx):(P=Zu,x=ko,A=Hx);let T=u.dir*(u.ori==0?1:-1),B=C(l[T==1?r:o]),D=B,I=[],k=[];for(let G=T==1?r:o;G>=r&&G<=o;G+=T)if(c[G]!=null){let J=l[G],j=C(J);I.push(D=j),k.push(b(c[G]))}let V={stroke:n(I,k,P,x,A,y),fill:null,clip:null,band:null,gaps:null,flags:Fo},N=V.stroke,[H,$]=Bd(i,s);if(a.fill!=null||H!=0){let G=V.fill=new Path2D(N),le=a.fillTo(i,s,a.min,a.max,H),J=b(le);x(G,D,J),x(G,B,J)}if(!a.spanGaps){let G=[];G.push(...kd(l,c,r,o,T,C,t)),V.gaps=G=a.gaps(i,s,r,o,G),V.clip=$u(G,u.ori,g,v,d,m)}return $!=0&&(V.band=$==2?[Es(i,s,r,o,N,-1),Es(i,s,r,o,N,1)]:Es(i,s,r,o,N,$)),V})}function RE(n){return CE(PE,n)}function PE(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,e[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,n[f+1],e[f+1])}return a}var Td=new Set;function ax(){for(let n of Td)n.syncRect(!0)}Oo&&(Rr(uA,Lo,ax),Rr(hA,Lo,ax,!0),Rr(zu,Lo,()=>{Fn.pxRatio=wt}));var IE=qx(),LE=Wx();function lx(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Ad(r,o,e,t))}function NE(n,e){return n.map((t,i)=>i==0?{}:xn({},e,t))}function Ad(n,e,t,i){return xn({},e==0?t:i,n)}function $x(n,e,t){return e==null?Do:[e,t]}var DE=$x;function UE(n,e,t){return e==null?Do:Vu(e,t,Id,!0)}function Yx(n,e,t,i){return e==null?Do:Wu(e,t,n.scales[i].log,!1)}var FE=Yx;function Zx(n,e,t,i){return e==null?Do:Pd(e,t,n.scales[i].log,!1)}var OE=Zx;function BE(n,e,t,i,s){let r=jn(z_(n),z_(e)),o=e-n,a=zi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?er.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function cx(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=bn((t=+s)*wt))+"px"),[n,e,t]}function kE(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Ft(e[2]*wt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Fn(n,e,t){let i={mode:Mt(n.mode,1)},s=i.mode;function r(_,M,R,L){let z=M.valToPct(_);return L+R*(M.dir==-1?1-z:z)}function o(_,M,R,L){let z=M.valToPct(_);return L+R*(M.dir==-1?z:1-z)}function a(_,M,R,L){return M.ori==0?r(_,M,R,L):o(_,M,R,L)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=bi(qT);if(n.id!=null&&(c.id=n.id),di(c,n.class),n.title){let _=bi(ZT,c);_.textContent=n.title}let u=ki("canvas"),h=i.ctx=u.getContext("2d"),f=bi(JT,c);Rr("click",f,_=>{_.target===g&&(Vt!=Br||Yt!=kr)&&Ln.click(i,_)},!0);let p=i.under=bi(KT,f);f.appendChild(u);let g=i.over=bi(jT,f);n=Uo(n);let v=+Mt(n.pxAlign,1),d=rx(v);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});let m=n.ms||.001,y=i.series=s==1?lx(n.series||[],j_,ix,!1):NE(n.series||[null],nx),C=i.axes=lx(n.axes||[],K_,ex,!0),b=i.scales={},P=i.bands=n.bands||[];P.forEach(_=>{_.fill=_t(_.fill||null),_.dir=Mt(_.dir,-1)});let A=s==2?y[1].facets[0].scale:y[0].scale,x={axes:cs,series:ft},T=(n.drawOrder||["axes","series"]).map(_=>x[_]);function B(_){let M=_.distr==3?R=>As(R>0?R:_.clamp(i,R,_.min,_.max,_.key)):_.distr==4?R=>dd(R,_.asinh):_.distr==100?R=>_.fwd(R):R=>R;return R=>{let L=M(R),{_min:z,_max:Z}=_,oe=Z-z;return(L-z)/oe}}function D(_){let M=b[_];if(M==null){let R=(n.scales||hl)[_]||hl;if(R.from!=null){D(R.from);let L=xn({},b[R.from],R,{key:_});L.valToPct=B(L),b[_]=L}else{M=b[_]=xn({},_==A?Ox:SE,R),M.key=_;let L=M.time,z=M.range,Z=Qs(z);if((_!=A||s==2&&!L)&&(Z&&(z[0]==null||z[1]==null)&&(z={min:z[0]==null?O_:{mode:1,hard:z[0],soft:z[0]},max:z[1]==null?O_:{mode:1,hard:z[1],soft:z[1]}},Z=!1),!Z&&qu(z))){let oe=z;z=(de,ye,Ne)=>ye==null?Do:Vu(ye,Ne,oe)}M.range=_t(z||(L?DE:_==A?M.distr==3?FE:M.distr==4?OE:$x:M.distr==3?Yx:M.distr==4?Zx:UE)),M.auto=_t(Z?!1:M.auto),M.clamp=_t(M.clamp||yE),M._min=M._max=null,M.valToPct=B(M)}}}D("x"),D("y"),s==1&&y.forEach(_=>{D(_.scale)}),C.forEach(_=>{D(_.scale)});for(let _ in n.scales)D(_);let I=b[A],k=I.distr,V,N;I.ori==0?(di(c,$T),V=r,N=o):(di(c,YT),V=o,N=r);let H={};for(let _ in b){let M=b[_];(M.min!=null||M.max!=null)&&(H[_]={min:M.min,max:M.max},M.min=M.max=null)}let $=n.tzDate||(_=>new Date(bn(_/m))),G=n.fmtDate||Dd,le=m==1?$A($):JA($),J=Y_($,$_(m==1?qA:ZA,G)),j=J_($,Z_(jA,G)),ie=[],fe=i.legend=xn({},tE,n.legend),ue=i.cursor=xn({},aE,{drag:{y:s==2}},n.cursor),Q=fe.show,me=ue.show,xe=fe.markers;fe.idxs=ie,xe.width=_t(xe.width),xe.dash=_t(xe.dash),xe.stroke=_t(xe.stroke),xe.fill=_t(xe.fill);let Ee,Me,He,it=[],Ve=[],ct,ot=!1,tt={};if(fe.live){let _=y[1]?y[1].values:null;ot=_!=null,ct=ot?_(i,1,0):{_:0};for(let M in ct)tt[M]=Cd}if(Q)if(Ee=ki("table",sA,c),He=ki("tbody",null,Ee),fe.mount(i,Ee),ot){Me=ki("thead",null,Ee,He);let _=ki("tr",null,Me);ki("th",null,_);for(var $t in ct)ki("th",w_,_).textContent=$t}else di(Ee,oA),fe.live&&di(Ee,rA);let Ot={show:!0},cn={show:!1};function It(_,M){if(M==0&&(ot||!fe.live||s==2))return Do;let R=[],L=ki("tr",aA,He,He.childNodes[M]);di(L,_.class),_.show||di(L,Cr);let z=ki("th",null,L);if(xe.show){let de=bi(lA,z);if(M>0){let ye=xe.width(i,M);ye&&(de.style.border=ye+"px "+xe.dash(i,M)+" "+xe.stroke(i,M)),de.style.background=xe.fill(i,M)}}let Z=bi(w_,z);_.label instanceof HTMLElement?Z.appendChild(_.label):Z.textContent=_.label,M>0&&(xe.show||(Z.style.color=_.width>0?xe.stroke(i,M):xe.fill(i,M)),vt("click",z,de=>{if(ue._lock)return;Je(de);let ye=y.indexOf(_);if((de.ctrlKey||de.metaKey)!=fe.isolate){let Ne=y.some((De,Fe)=>Fe>0&&Fe!=ye&&De.show);y.forEach((De,Fe)=>{Fe>0&&Xi(Fe,Ne?Fe==ye?Ot:cn:Ot,!0,pn.setSeries)})}else Xi(ye,{show:!_.show},!0,pn.setSeries)},!1),Ke&&vt(C_,z,de=>{ue._lock||(Je(de),Xi(y.indexOf(_),Vr,!0,pn.setSeries))},!1));for(var oe in ct){let de=ki("td",cA,L);de.textContent="--",R.push(de)}return[L,R]}let Tn=new Map;function vt(_,M,R,L=!0){let z=Tn.get(M)||{},Z=ue.bind[_](i,M,R,L);Z&&(Rr(_,M,z[_]=Z),Tn.set(M,z))}function vn(_,M,R){let L=Tn.get(M)||{};for(let z in L)(_==null||z==_)&&(yd(z,M,L[z]),delete L[z]);_==null&&Tn.delete(M)}let jt=0,un=0,F=0,Re=0,$e=0,st=0,be=$e,Dt=st,ze=F,qe=Re,E=0,S=0,X=0,ce=0;i.bbox={};let re=!1,_e=!1,ve=!1,ee=!1,ne=!1,pe=!1;function U(_,M,R){(R||_!=i.width||M!=i.height)&&se(_,M),at(!1),ve=!0,_e=!0,On()}function se(_,M){i.width=jt=F=_,i.height=un=Re=M,$e=st=0,Se(),Ge();let R=i.bbox;E=R.left=Ar($e*wt,.5),S=R.top=Ar(st*wt,.5),X=R.width=Ar(F*wt,.5),ce=R.height=Ar(Re*wt,.5)}let te=3;function we(){let _=!1,M=0;for(;!_;){M++;let R=Ur(M),L=Wi(M);_=M==te||R&&L,_||(se(i.width,i.height),_e=!0)}}function ge({width:_,height:M}){U(_,M)}i.setSize=ge;function Se(){let _=!1,M=!1,R=!1,L=!1;C.forEach((z,Z)=>{if(z.show&&z._show){let{side:oe,_size:de}=z,ye=oe%2,Ne=z.label!=null?z.labelSize:0,De=de+Ne;De>0&&(ye?(F-=De,oe==3?($e+=De,L=!0):R=!0):(Re-=De,oe==0?(st+=De,_=!0):M=!0))}}),Gi[0]=_,Gi[1]=R,Gi[2]=M,Gi[3]=L,F-=Ei[1]+Ei[3],$e+=Ei[3],Re-=Ei[2]+Ei[0],st+=Ei[0]}function Ge(){let _=$e+F,M=st+Re,R=$e,L=st;function z(Z,oe){switch(Z){case 1:return _+=oe,_-oe;case 2:return M+=oe,M-oe;case 3:return R-=oe,R+oe;case 0:return L-=oe,L+oe}}C.forEach((Z,oe)=>{if(Z.show&&Z._show){let de=Z.side;Z._pos=z(de,Z._size),Z.label!=null&&(Z._lpos=z(de,Z.labelSize))}})}if(ue.dataIdx==null){let _=ue.hover,M=_.skip=new Set(_.skip??[]);M.add(void 0);let R=_.prox=_t(_.prox),L=_.bias??=0;ue.dataIdx=(z,Z,oe,de)=>{if(Z==0)return oe;let ye=oe,Ne=R(z,Z,oe,de)??Ut,De=Ne>=0&&Ne<Ut,Fe=I.ori==0?F:Re,nt=ue.left,bt=e[0],St=e[Z];if(M.has(St[oe])){ye=null;let dt=null,Ze=null,We;if(L==0||L==-1)for(We=oe;dt==null&&We-- >0;)M.has(St[We])||(dt=We);if(L==0||L==1)for(We=oe;Ze==null&&We++<St.length;)M.has(St[We])||(Ze=We);if(dt!=null||Ze!=null)if(De){let Ht=dt==null?-1/0:V(bt[dt],I,Fe,0),tn=Ze==null?1/0:V(bt[Ze],I,Fe,0),Rn=nt-Ht,Lt=tn-nt;Rn<=Lt?Rn<=Ne&&(ye=dt):Lt<=Ne&&(ye=Ze)}else ye=Ze==null?dt:dt==null?Ze:oe-dt<=Ze-oe?dt:Ze}else De&&wn(nt-V(bt[oe],I,Fe,0))>Ne&&(ye=null);return ye}}let Je=_=>{ue.event=_};ue.idxs=ie,ue._lock=!1;let ae=ue.points;ae.show=_t(ae.show),ae.size=_t(ae.size),ae.stroke=_t(ae.stroke),ae.width=_t(ae.width),ae.fill=_t(ae.fill);let Oe=i.focus=xn({},n.focus||{alpha:.3},ue.focus),Ke=Oe.prox>=0,Ce=Ke&&ae.one,rt=[],zt=[],Hn=[];function Wo(_,M){let R=ae.show(i,M);if(R instanceof HTMLElement)return di(R,iA),di(R,_.class),ss(R,-10,-10,F,Re),g.insertBefore(R,rt[M]),R}function Lr(_,M){if(s==1||M>0){let R=s==1&&b[_.scale].time,L=_.value;_.value=R?H_(L)?J_($,Z_(L,G)):L||j:L||_E,_.label=_.label||(R?cE:lE)}if(Ce||M>0){_.width=_.width==null?1:_.width,_.paths=_.paths||IE||SA,_.fillTo=_t(_.fillTo||ME),_.pxAlign=+Mt(_.pxAlign,v),_.pxRound=rx(_.pxAlign),_.stroke=_t(_.stroke||null),_.fill=_t(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let R=xE(jn(1,_.width),1),L=_.points=xn({},{size:R,width:jn(1,R*.2),stroke:_.stroke,space:R*2,paths:LE,_stroke:null,_fill:null},_.points);L.show=_t(L.show),L.filter=_t(L.filter),L.fill=_t(L.fill),L.stroke=_t(L.stroke),L.paths=_t(L.paths),L.pxAlign=_.pxAlign}if(Q){let R=It(_,M);it.splice(M,0,R[0]),Ve.splice(M,0,R[1]),fe.values.push(null)}if(me){ie.splice(M,0,null);let R=null;Ce?M==0&&(R=Wo(_,M)):M>0&&(R=Wo(_,M)),rt.splice(M,0,R),zt.splice(M,0,0),Hn.splice(M,0,0)}Cn("addSeries",M)}function nh(_,M){M=M??y.length,_=s==1?Ad(_,M,j_,ix):Ad(_,M,{},nx),y.splice(M,0,_),Lr(y[M],M)}i.addSeries=nh;function gl(_){if(y.splice(_,1),Q){fe.values.splice(_,1),Ve.splice(_,1);let M=it.splice(_,1)[0];vn(null,M.firstChild),M.remove()}me&&(ie.splice(_,1),rt.splice(_,1)[0].remove(),zt.splice(_,1),Hn.splice(_,1)),Cn("delSeries",_)}i.delSeries=gl;let Gi=[!1,!1,!1,!1];function os(_,M){if(_._show=_.show,_.show){let R=_.side%2,L=b[_.scale];L==null&&(_.scale=R?y[1].scale:A,L=b[_.scale]);let z=L.time;_.size=_t(_.size),_.space=_t(_.space),_.rotate=_t(_.rotate),Qs(_.incrs)&&_.incrs.forEach(oe=>{!er.has(oe)&&er.set(oe,xx(oe))}),_.incrs=_t(_.incrs||(L.distr==2?HA:z?m==1?XA:YA:Er)),_.splits=_t(_.splits||(z&&L.distr==1?le:L.distr==3?Md:L.distr==4?fE:hE)),_.stroke=_t(_.stroke),_.grid.stroke=_t(_.grid.stroke),_.ticks.stroke=_t(_.ticks.stroke),_.border.stroke=_t(_.border.stroke);let Z=_.values;_.values=Qs(Z)&&!Qs(Z[0])?_t(Z):z?Qs(Z)?Y_($,$_(Z,G)):H_(Z)?KA($,Z):Z||J:Z||uE,_.filter=_t(_.filter||(L.distr>=3&&L.log==10?mE:L.distr==3&&L.log==2?gE:gx)),_.font=cx(_.font),_.labelFont=cx(_.labelFont),_._size=_.size(i,null,M,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Gi[M]=!0,_._el=bi(QT,f))}}function as(_,M,R,L){let[z,Z,oe,de]=R,ye=M%2,Ne=0;return ye==0&&(de||Z)&&(Ne=M==0&&!z||M==2&&!oe?bn(K_.size/3):0),ye==1&&(z||oe)&&(Ne=M==1&&!Z||M==3&&!de?bn(ex.size/2):0),Ne}let Xo=i.padding=(n.padding||[as,as,as,as]).map(_=>_t(Mt(_,as))),Ei=i._padding=Xo.map((_,M)=>_(i,M,Gi,0)),Qt,on=null,an=null,Hi=s==1?y[0].idxs:null,si=null,Rs=!1;function qo(_,M){if(e=_??[],i.data=i._data=e,s==2){Qt=0;for(let R=1;R<y.length;R++)Qt+=e[R][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),si=e[0],Qt=si.length;let R=e;if(k==2){R=e.slice();let L=R[0]=Array(Qt);for(let z=0;z<Qt;z++)L[z]=z}i._data=e=R}if(at(!0),Cn("setData"),k==2&&(ve=!0),M!==!1){let R=I;R.auto(i,Rs)?$o():Ls(A,R.min,R.max),ee=ee||ue.left>=0,pe=!0,On()}}i.setData=qo;function $o(){Rs=!0;let _,M;s==1&&(Qt>0?(on=Hi[0]=0,an=Hi[1]=Qt-1,_=e[0][on],M=e[0][an],k==2?(_=on,M=an):_==M&&(k==3?[_,M]=Wu(_,_,I.log,!1):k==4?[_,M]=Pd(_,_,I.log,!1):I.time?M=_+bn(86400/m):[_,M]=Vu(_,M,Id,!0))):(on=Hi[0]=_=null,an=Hi[1]=M=null)),Ls(A,_,M)}let Nr,Ps,Dr,w,O,K,q,Y,Te,Pe;function Ae(_,M,R,L,z,Z){_??=A_,R??=Nd,L??="butt",z??=A_,Z??="round",_!=Nr&&(h.strokeStyle=Nr=_),z!=Ps&&(h.fillStyle=Ps=z),M!=Dr&&(h.lineWidth=Dr=M),Z!=O&&(h.lineJoin=O=Z),L!=K&&(h.lineCap=K=L),R!=w&&h.setLineDash(w=R)}function Ie(_,M,R,L){M!=Ps&&(h.fillStyle=Ps=M),_!=q&&(h.font=q=_),R!=Y&&(h.textAlign=Y=R),L!=Te&&(h.textBaseline=Te=L)}function ke(_,M,R,L,z=0){if(L.length>0&&_.auto(i,Rs)&&(M==null||M.min==null)){let Z=Mt(on,0),oe=Mt(an,L.length-1),de=R.min==null?mA(L,Z,oe,z,_.distr==3):[R.min,R.max];_.min=Vi(_.min,R.min=de[0]),_.max=jn(_.max,R.max=de[1])}}let Qe={min:null,max:null};function ht(){for(let L in b){let z=b[L];H[L]==null&&(z.min==null||H[A]!=null&&z.auto(i,Rs))&&(H[L]=Qe)}for(let L in b){let z=b[L];H[L]==null&&z.from!=null&&H[z.from]!=null&&(H[L]=Qe)}H[A]!=null&&at(!0);let _={};for(let L in H){let z=H[L];if(z!=null){let Z=_[L]=Uo(b[L],wA);if(z.min!=null)xn(Z,z);else if(L!=A||s==2)if(Qt==0&&Z.from==null){let oe=Z.range(i,null,null,L);Z.min=oe[0],Z.max=oe[1]}else Z.min=Ut,Z.max=-Ut}}if(Qt>0){y.forEach((L,z)=>{if(s==1){let Z=L.scale,oe=H[Z];if(oe==null)return;let de=_[Z];if(z==0){let ye=de.range(i,de.min,de.max,Z);de.min=ye[0],de.max=ye[1],on=zi(de.min,e[0]),an=zi(de.max,e[0]),an-on>1&&(e[0][on]<de.min&&on++,e[0][an]>de.max&&an--),L.min=si[on],L.max=si[an]}else L.show&&L.auto&&ke(de,oe,L,e[z],L.sorted);L.idxs[0]=on,L.idxs[1]=an}else if(z>0&&L.show&&L.auto){let[Z,oe]=L.facets,de=Z.scale,ye=oe.scale,[Ne,De]=e[z],Fe=_[de],nt=_[ye];Fe!=null&&ke(Fe,H[de],Z,Ne,Z.sorted),nt!=null&&ke(nt,H[ye],oe,De,oe.sorted),L.min=oe.min,L.max=oe.max}});for(let L in _){let z=_[L],Z=H[L];if(z.from==null&&(Z==null||Z.min==null)){let oe=z.range(i,z.min==Ut?null:z.min,z.max==-Ut?null:z.max,L);z.min=oe[0],z.max=oe[1]}}}for(let L in _){let z=_[L];if(z.from!=null){let Z=_[z.from];if(Z.min==null)z.min=z.max=null;else{let oe=z.range(i,Z.min,Z.max,L);z.min=oe[0],z.max=oe[1]}}}let M={},R=!1;for(let L in _){let z=_[L],Z=b[L];if(Z.min!=z.min||Z.max!=z.max){Z.min=z.min,Z.max=z.max;let oe=Z.distr;Z._min=oe==3?As(Z.min):oe==4?dd(Z.min,Z.asinh):oe==100?Z.fwd(Z.min):Z.min,Z._max=oe==3?As(Z.max):oe==4?dd(Z.max,Z.asinh):oe==100?Z.fwd(Z.max):Z.max,M[L]=R=!0}}if(R){y.forEach((L,z)=>{s==2?z>0&&M.y&&(L._paths=null):M[L.scale]&&(L._paths=null)});for(let L in M)ve=!0,Cn("setScale",L);me&&ue.left>=0&&(ee=pe=!0)}for(let L in H)H[L]=null}function Be(_){let M=Sd(on-1,0,Qt-1),R=Sd(an+1,0,Qt-1);for(;_[M]==null&&M>0;)M--;for(;_[R]==null&&R<Qt-1;)R++;return[M,R]}function ft(){if(Qt>0){let _=y.some(M=>M._focus)&&Pe!=Oe.alpha;_&&(h.globalAlpha=Pe=Oe.alpha),y.forEach((M,R)=>{if(R>0&&M.show&&(Jt(R,!1),Jt(R,!0),M._paths==null)){let L=Pe;Pe!=M.alpha&&(h.globalAlpha=Pe=M.alpha);let z=s==2?[0,e[R][0].length-1]:Be(e[R]);M._paths=M.paths(i,R,z[0],z[1]),Pe!=L&&(h.globalAlpha=Pe=L)}}),y.forEach((M,R)=>{if(R>0&&M.show){let L=Pe;Pe!=M.alpha&&(h.globalAlpha=Pe=M.alpha),M._paths!=null&&Ct(R,!1);{let z=M._paths!=null?M._paths.gaps:null,Z=M.points.show(i,R,on,an,z),oe=M.points.filter(i,R,Z,z);(Z||oe)&&(M.points._paths=M.points.paths(i,R,on,an,oe),Ct(R,!0))}Pe!=L&&(h.globalAlpha=Pe=L),Cn("drawSeries",R)}}),_&&(h.globalAlpha=Pe=1)}}function Jt(_,M){let R=M?y[_].points:y[_];R._stroke=R.stroke(i,_),R._fill=R.fill(i,_)}function Ct(_,M){let R=M?y[_].points:y[_],{stroke:L,fill:z,clip:Z,flags:oe,_stroke:de=R._stroke,_fill:ye=R._fill,_width:Ne=R.width}=R._paths;Ne=Ft(Ne*wt,3);let De=null,Fe=Ne%2/2;M&&ye==null&&(ye=Ne>0?"#fff":de);let nt=R.pxAlign==1&&Fe>0;if(nt&&h.translate(Fe,Fe),!M){let bt=E-Ne/2,St=S-Ne/2,dt=X+Ne,Ze=ce+Ne;De=new Path2D,De.rect(bt,St,dt,Ze)}M?Ue(de,Ne,R.dash,R.cap,ye,L,z,oe,Z):Rt(_,de,Ne,R.dash,R.cap,ye,L,z,oe,De,Z),nt&&h.translate(-Fe,-Fe)}function Rt(_,M,R,L,z,Z,oe,de,ye,Ne,De){let Fe=!1;ye!=0&&P.forEach((nt,bt)=>{if(nt.series[0]==_){let St=y[nt.series[1]],dt=e[nt.series[1]],Ze=(St._paths||hl).band;Qs(Ze)&&(Ze=nt.dir==1?Ze[0]:Ze[1]);let We,Ht=null;St.show&&Ze&&_A(dt,on,an)?(Ht=nt.fill(i,bt)||Z,We=St._paths.clip):Ze=null,Ue(M,R,L,z,Ht,oe,de,ye,Ne,De,We,Ze),Fe=!0}}),Fe||Ue(M,R,L,z,Z,oe,de,ye,Ne,De)}let yn=Fo|wd;function Ue(_,M,R,L,z,Z,oe,de,ye,Ne,De,Fe){Ae(_,M,R,L,z),(ye||Ne||Fe)&&(h.save(),ye&&h.clip(ye),Ne&&h.clip(Ne)),Fe?(de&yn)==yn?(h.clip(Fe),De&&h.clip(De),mt(z,oe),hn(_,Z,M)):de&wd?(mt(z,oe),h.clip(Fe),hn(_,Z,M)):de&Fo&&(h.save(),h.clip(Fe),De&&h.clip(De),mt(z,oe),h.restore(),hn(_,Z,M)):(mt(z,oe),hn(_,Z,M)),(ye||Ne||Fe)&&h.restore()}function hn(_,M,R){R>0&&(M instanceof Map?M.forEach((L,z)=>{h.strokeStyle=Nr=z,h.stroke(L)}):M!=null&&_&&h.stroke(M))}function mt(_,M){M instanceof Map?M.forEach((R,L)=>{h.fillStyle=Ps=L,h.fill(R)}):M!=null&&_&&h.fill(M)}function ls(_,M,R,L){let z=C[_],Z;if(L<=0)Z=[0,0];else{let oe=z._space=z.space(i,_,M,R,L),de=z._incrs=z.incrs(i,_,M,R,L,oe);Z=BE(M,R,de,L,oe)}return z._found=Z}function fn(_,M,R,L,z,Z,oe,de,ye,Ne){let De=oe%2/2;v==1&&h.translate(De,De),Ae(de,oe,ye,Ne,de),h.beginPath();let Fe,nt,bt,St,dt=z+(L==0||L==3?-Z:Z);R==0?(nt=z,St=dt):(Fe=z,bt=dt);for(let Ze=0;Ze<_.length;Ze++)M[Ze]!=null&&(R==0?Fe=bt=_[Ze]:nt=St=_[Ze],h.moveTo(Fe,nt),h.lineTo(bt,St));h.stroke(),v==1&&h.translate(-De,-De)}function Ur(_){let M=!0;return C.forEach((R,L)=>{if(!R.show)return;let z=b[R.scale];if(z.min==null){R._show&&(M=!1,R._show=!1,at(!1));return}else R._show||(M=!1,R._show=!0,at(!1));let Z=R.side,oe=Z%2,{min:de,max:ye}=z,[Ne,De]=ls(L,de,ye,oe==0?F:Re);if(De==0)return;let Fe=z.distr==2,nt=R._splits=R.splits(i,L,de,ye,Ne,De,Fe),bt=z.distr==2?nt.map(We=>si[We]):nt,St=z.distr==2?si[nt[1]]-si[nt[0]]:Ne,dt=R._values=R.values(i,R.filter(i,bt,L,De,St),L,De,St);R._rotate=Z==2?R.rotate(i,dt,L,De):0;let Ze=R._size;R._size=wi(R.size(i,dt,L,_)),Ze!=null&&R._size!=Ze&&(M=!1)}),M}function Wi(_){let M=!0;return Xo.forEach((R,L)=>{let z=R(i,L,Gi,_);z!=Ei[L]&&(M=!1),Ei[L]=z}),M}function cs(){for(let _=0;_<C.length;_++){let M=C[_];if(!M.show||!M._show)continue;let R=M.side,L=R%2,z,Z,oe=M.stroke(i,_),de=R==0||R==3?-1:1,[ye,Ne]=M._found;if(M.label!=null){let qn=M.labelGap*de,ai=bn((M._lpos+qn)*wt);Ie(M.labelFont[0],oe,"center",R==2?"top":T_),h.save(),L==1?(z=Z=0,h.translate(ai,bn(S+ce/2)),h.rotate((R==3?-ku:ku)/2)):(z=bn(E+X/2),Z=ai);let sr=px(M.label)?M.label(i,_,ye,Ne):M.label;h.fillText(sr,z,Z),h.restore()}if(Ne==0)continue;let De=b[M.scale],Fe=L==0?X:ce,nt=L==0?E:S,bt=M._splits,St=De.distr==2?bt.map(qn=>si[qn]):bt,dt=De.distr==2?si[bt[1]]-si[bt[0]]:ye,Ze=M.ticks,We=M.border,Ht=Ze.show?Ze.size:0,tn=bn(Ht*wt),Rn=bn((M.alignTo==2?M._size-Ht-M.gap:M.gap)*wt),Lt=M._rotate*-ku/180,nn=d(M._pos*wt),ri=(tn+Rn)*de,Xn=nn+ri;Z=L==0?Xn:0,z=L==1?Xn:0;let _i=M.font[0],Ci=M.align==1?Po:M.align==2?ud:Lt>0?Po:Lt<0?ud:L==0?"center":R==3?ud:Po,$i=Lt||L==1?"middle":R==2?"top":T_;Ie(_i,oe,Ci,$i);let oi=M.font[1]*M.lineGap,xi=bt.map(qn=>d(a(qn,De,Fe,nt))),Ri=M._values;for(let qn=0;qn<Ri.length;qn++){let ai=Ri[qn];if(ai!=null){L==0?z=xi[qn]:Z=xi[qn],ai=""+ai;let sr=ai.indexOf(`
`)==-1?[ai]:ai.split(/\n/gm);for(let $n=0;$n<sr.length;$n++){let gp=sr[$n];Lt?(h.save(),h.translate(z,Z+$n*oi),h.rotate(Lt),h.fillText(gp,0,0),h.restore()):h.fillText(gp,z,Z+$n*oi)}}}Ze.show&&fn(xi,Ze.filter(i,St,_,Ne,dt),L,R,nn,tn,Ft(Ze.width*wt,3),Ze.stroke(i,_),Ze.dash,Ze.cap);let Yi=M.grid;Yi.show&&fn(xi,Yi.filter(i,St,_,Ne,dt),L,L==0?2:1,L==0?S:E,L==0?ce:X,Ft(Yi.width*wt,3),Yi.stroke(i,_),Yi.dash,Yi.cap),We.show&&fn([nn],[1],L==0?1:0,L==0?1:2,L==1?S:E,L==1?ce:X,Ft(We.width*wt,3),We.stroke(i,_),We.dash,We.cap)}Cn("drawAxes")}function at(_){y.forEach((M,R)=>{R>0&&(M._paths=null,_&&(s==1?(M.min=null,M.max=null):M.facets.forEach(L=>{L.min=null,L.max=null})))})}let en=!1,Wn=!1,Pt=[];function dn(){Wn=!1;for(let _=0;_<Pt.length;_++)Cn(...Pt[_]);Pt.length=0}function On(){en||(IA(jd),en=!0)}function _l(_,M=!1){en=!0,Wn=M,_(i),jd(),M&&Pt.length>0&&queueMicrotask(dn)}i.batch=_l;function jd(){if(re&&(ht(),re=!1),ve&&(we(),ve=!1),_e){if(Xt(p,Po,$e),Xt(p,"top",st),Xt(p,al,F),Xt(p,ll,Re),Xt(g,Po,$e),Xt(g,"top",st),Xt(g,al,F),Xt(g,ll,Re),Xt(f,al,jt),Xt(f,ll,un),u.width=bn(jt*wt),u.height=bn(un*wt),C.forEach(({_el:_,_show:M,_size:R,_pos:L,side:z})=>{if(_!=null)if(M){let Z=z===3||z===0?R:0,oe=z%2==1;Xt(_,oe?"left":"top",L-Z),Xt(_,oe?"width":"height",R),Xt(_,oe?"top":"left",oe?st:$e),Xt(_,oe?"height":"width",oe?Re:F),vd(_,Cr)}else di(_,Cr)}),Nr=Ps=Dr=O=K=q=Y=Te=w=null,Pe=1,Jo(!0),$e!=be||st!=Dt||F!=ze||Re!=qe){at(!1);let _=F/ze,M=Re/qe;if(me&&!ee&&ue.left>=0){ue.left*=_,ue.top*=M,Fr&&ss(Fr,bn(ue.left),0,F,Re),Or&&ss(Or,0,bn(ue.top),F,Re);for(let R=0;R<rt.length;R++){let L=rt[R];L!=null&&(zt[R]*=_,Hn[R]*=M,ss(L,wi(zt[R]),wi(Hn[R]),F,Re))}}if(Gt.show&&!ne&&Gt.left>=0&&Gt.width>0){Gt.left*=_,Gt.width*=_,Gt.top*=M,Gt.height*=M;for(let R in lh)Xt(zr,R,Gt[R])}be=$e,Dt=st,ze=F,qe=Re}Cn("setSize"),_e=!1}jt>0&&un>0&&(h.clearRect(0,0,u.width,u.height),Cn("drawClear"),T.forEach(_=>_()),Cn("draw")),Gt.show&&ne&&(xl(Gt),ne=!1),me&&ee&&(ir(null,!0,!1),ee=!1),fe.show&&fe.live&&pe&&(oh(),pe=!1),l||(l=!0,i.status=1,Cn("ready")),Rs=!1,en=!1}i.redraw=(_,M)=>{ve=M||!1,_!==!1?Ls(A,I.min,I.max):On()};function ih(_,M){let R=b[_];if(R.from==null){if(Qt==0){let L=R.range(i,M.min,M.max,_);M.min=L[0],M.max=L[1]}if(M.min>M.max){let L=M.min;M.min=M.max,M.max=L}if(Qt>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;_==A&&R.distr==2&&Qt>0&&(M.min=zi(M.min,e[0]),M.max=zi(M.max,e[0]),M.min==M.max&&M.max++),H[_]=M,re=!0,On()}}i.setScale=ih;let sh,rh,Fr,Or,Qd,ep,Br,kr,tp,np,Vt,Yt,Is=!1,Ln=ue.drag,An=Ln.x,En=Ln.y;me&&(ue.x&&(sh=bi(tA,g)),ue.y&&(rh=bi(nA,g)),I.ori==0?(Fr=sh,Or=rh):(Fr=rh,Or=sh),Vt=ue.left,Yt=ue.top);let Gt=i.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),zr=Gt.show?bi(eA,Gt.over?g:p):null;function xl(_,M){if(Gt.show){for(let R in _)Gt[R]=_[R],R in lh&&Xt(zr,R,_[R]);M!==!1&&Cn("setSelect")}}i.setSelect=xl;function ny(_){if(y[_].show)Q&&vd(it[_],Cr);else if(Q&&di(it[_],Cr),me){let R=Ce?rt[0]:rt[_];R!=null&&ss(R,-10,-10,F,Re)}}function Ls(_,M,R){ih(_,{min:M,max:R})}function Xi(_,M,R,L){M.focus!=null&&ay(_),M.show!=null&&y.forEach((z,Z)=>{Z>0&&(_==Z||_==null)&&(z.show=M.show,ny(Z),s==2?(Ls(z.facets[0].scale,null,null),Ls(z.facets[1].scale,null,null)):Ls(z.scale,null,null),On())}),R!==!1&&Cn("setSeries",_,M),L&&Ko("setSeries",i,_,M)}i.setSeries=Xi;function iy(_,M){xn(P[_],M)}function sy(_,M){_.fill=_t(_.fill||null),_.dir=Mt(_.dir,-1),M=M??P.length,P.splice(M,0,_)}function ry(_){_==null?P.length=0:P.splice(_,1)}i.addBand=sy,i.setBand=iy,i.delBand=ry;function oy(_,M){y[_].alpha=M,me&&rt[_]!=null&&(rt[_].style.opacity=M),Q&&it[_]&&(it[_].style.opacity=M)}let us,Ns,nr,Vr={focus:!0};function ay(_){if(_!=nr){let M=_==null,R=Oe.alpha!=1;y.forEach((L,z)=>{if(s==1||z>0){let Z=M||z==0||z==_;L._focus=M?null:Z,R&&oy(z,Z?1:Oe.alpha)}}),nr=_,R&&On()}}Q&&Ke&&vt(R_,Ee,_=>{ue._lock||(Je(_),nr!=null&&Xi(null,Vr,!0,pn.setSeries))});function qi(_,M,R){let L=b[M];R&&(_=_/wt-(L.ori==1?st:$e));let z=F;L.ori==1&&(z=Re,_=z-_),L.dir==-1&&(_=z-_);let Z=L._min,oe=L._max,de=_/z,ye=Z+(oe-Z)*de,Ne=L.distr;return Ne==3?No(10,ye):Ne==4?vA(ye,L.asinh):Ne==100?L.bwd(ye):ye}function ly(_,M){let R=qi(_,A,M);return zi(R,e[0],on,an)}i.valToIdx=_=>zi(_,e[0]),i.posToIdx=ly,i.posToVal=qi,i.valToPos=(_,M,R)=>b[M].ori==0?r(_,b[M],R?X:F,R?E:0):o(_,b[M],R?ce:Re,R?S:0),i.setCursor=(_,M,R)=>{Vt=_.left,Yt=_.top,ir(null,M,R)};function ip(_,M){Xt(zr,Po,Gt.left=_),Xt(zr,al,Gt.width=M)}function sp(_,M){Xt(zr,"top",Gt.top=_),Xt(zr,ll,Gt.height=M)}let Yo=I.ori==0?ip:sp,Zo=I.ori==1?ip:sp;function cy(){if(Q&&fe.live)for(let _=s==2?1:0;_<y.length;_++){if(_==0&&ot)continue;let M=fe.values[_],R=0;for(let L in M)Ve[_][R++].firstChild.nodeValue=M[L]}}function oh(_,M){if(_!=null&&(_.idxs?_.idxs.forEach((R,L)=>{ie[L]=R}):bA(_.idx)||ie.fill(_.idx),fe.idx=ie[0]),Q&&fe.live){for(let R=0;R<y.length;R++)(R>0||s==1&&!ot)&&uy(R,ie[R]);cy()}pe=!1,M!==!1&&Cn("setLegend")}i.setLegend=oh;function uy(_,M){let R=y[_],L=_==0&&k==2?si:e[_],z;ot?z=R.values(i,_,M)??tt:(z=R.value(i,M==null?null:L[M],_,M),z=z==null?tt:{_:z}),fe.values[_]=z}function ir(_,M,R){tp=Vt,np=Yt,[Vt,Yt]=ue.move(i,Vt,Yt),ue.left=Vt,ue.top=Yt,me&&(Fr&&ss(Fr,bn(Vt),0,F,Re),Or&&ss(Or,0,bn(Yt),F,Re));let L,z=on>an;us=Ut,Ns=null;let Z=I.ori==0?F:Re,oe=I.ori==1?F:Re;if(Vt<0||Qt==0||z){L=ue.idx=null;for(let de=0;de<y.length;de++){let ye=rt[de];ye!=null&&ss(ye,-10,-10,F,Re)}Ke&&Xi(null,Vr,!0,_==null&&pn.setSeries),fe.live&&(ie.fill(L),pe=!0)}else{let de,ye,Ne;s==1&&(de=I.ori==0?Vt:Yt,ye=qi(de,A),L=ue.idx=zi(ye,e[0],on,an),Ne=V(e[0][L],I,Z,0));let De=-10,Fe=-10,nt=0,bt=0,St=!0,dt="",Ze="";for(let We=s==2?1:0;We<y.length;We++){let Ht=y[We],tn=ie[We],Rn=tn==null?null:s==1?e[We][tn]:e[We][1][tn],Lt=ue.dataIdx(i,We,L,ye),nn=Lt==null?null:s==1?e[We][Lt]:e[We][1][Lt];if(pe=pe||nn!=Rn||Lt!=tn,ie[We]=Lt,We>0&&Ht.show){let ri=Lt==null?-10:Lt==L?Ne:V(s==1?e[0][Lt]:e[We][0][Lt],I,Z,0),Xn=nn==null?-10:N(nn,s==1?b[Ht.scale]:b[Ht.facets[1].scale],oe,0);if(Ke&&nn!=null){let _i=I.ori==1?Vt:Yt,Ci=wn(Oe.dist(i,We,Lt,Xn,_i));if(Ci<us){let $i=Oe.bias;if($i!=0){let oi=qi(_i,Ht.scale),xi=nn>=0?1:-1,Ri=oi>=0?1:-1;Ri==xi&&(Ri==1?$i==1?nn>=oi:nn<=oi:$i==1?nn<=oi:nn>=oi)&&(us=Ci,Ns=We)}else us=Ci,Ns=We}}if(pe||Ce){let _i,Ci;I.ori==0?(_i=ri,Ci=Xn):(_i=Xn,Ci=ri);let $i,oi,xi,Ri,Yi,qn,ai=!0,sr=ae.bbox;if(sr!=null){ai=!1;let $n=sr(i,We);xi=$n.left,Ri=$n.top,$i=$n.width,oi=$n.height}else xi=_i,Ri=Ci,$i=oi=ae.size(i,We);if(qn=ae.fill(i,We),Yi=ae.stroke(i,We),Ce)We==Ns&&us<=Oe.prox&&(De=xi,Fe=Ri,nt=$i,bt=oi,St=ai,dt=qn,Ze=Yi);else{let $n=rt[We];$n!=null&&(zt[We]=xi,Hn[We]=Ri,F_($n,$i,oi,ai),D_($n,qn,Yi),ss($n,wi(xi),wi(Ri),F,Re))}}}}if(Ce){let We=Oe.prox,Ht=nr==null?us<=We:us>We||Ns!=nr;if(pe||Ht){let tn=rt[0];tn!=null&&(zt[0]=De,Hn[0]=Fe,F_(tn,nt,bt,St),D_(tn,dt,Ze),ss(tn,wi(De),wi(Fe),F,Re))}}}if(Gt.show&&Is)if(_!=null){let[de,ye]=pn.scales,[Ne,De]=pn.match,[Fe,nt]=_.cursor.sync.scales,bt=_.cursor.drag;if(An=bt._x,En=bt._y,An||En){let{left:St,top:dt,width:Ze,height:We}=_.select,Ht=_.scales[Fe].ori,tn=_.posToVal,Rn,Lt,nn,ri,Xn,_i=de!=null&&Ne(de,Fe),Ci=ye!=null&&De(ye,nt);_i&&An?(Ht==0?(Rn=St,Lt=Ze):(Rn=dt,Lt=We),nn=b[de],ri=V(tn(Rn,Fe),nn,Z,0),Xn=V(tn(Rn+Lt,Fe),nn,Z,0),Yo(Vi(ri,Xn),wn(Xn-ri))):Yo(0,Z),Ci&&En?(Ht==1?(Rn=St,Lt=Ze):(Rn=dt,Lt=We),nn=b[ye],ri=N(tn(Rn,nt),nn,oe,0),Xn=N(tn(Rn+Lt,nt),nn,oe,0),Zo(Vi(ri,Xn),wn(Xn-ri))):Zo(0,oe)}else ch()}else{let de=wn(tp-Qd),ye=wn(np-ep);if(I.ori==1){let nt=de;de=ye,ye=nt}An=Ln.x&&de>=Ln.dist,En=Ln.y&&ye>=Ln.dist;let Ne=Ln.uni;Ne!=null?An&&En&&(An=de>=Ne,En=ye>=Ne,!An&&!En&&(ye>de?En=!0:An=!0)):Ln.x&&Ln.y&&(An||En)&&(An=En=!0);let De,Fe;An&&(I.ori==0?(De=Br,Fe=Vt):(De=kr,Fe=Yt),Yo(Vi(De,Fe),wn(Fe-De)),En||Zo(0,oe)),En&&(I.ori==1?(De=Br,Fe=Vt):(De=kr,Fe=Yt),Zo(Vi(De,Fe),wn(Fe-De)),An||Yo(0,Z)),!An&&!En&&(Yo(0,0),Zo(0,0))}if(Ln._x=An,Ln._y=En,_==null){if(R){if(mp!=null){let[de,ye]=pn.scales;pn.values[0]=de!=null?qi(I.ori==0?Vt:Yt,de):null,pn.values[1]=ye!=null?qi(I.ori==1?Vt:Yt,ye):null}Ko(hd,i,Vt,Yt,F,Re,L)}if(Ke){let de=R&&pn.setSeries,ye=Oe.prox;nr==null?us<=ye&&Xi(Ns,Vr,!0,de):us>ye?Xi(null,Vr,!0,de):Ns!=nr&&Xi(Ns,Vr,!0,de)}}pe&&(fe.idx=L,oh()),M!==!1&&Cn("setCursor")}let Ds=null;Object.defineProperty(i,"rect",{get(){return Ds==null&&Jo(!1),Ds}});function Jo(_=!1){_?Ds=null:(Ds=g.getBoundingClientRect(),Cn("syncRect",Ds))}function rp(_,M,R,L,z,Z,oe){ue._lock||Is&&_!=null&&_.movementX==0&&_.movementY==0||(ah(_,M,R,L,z,Z,oe,!1,_!=null),_!=null?ir(null,!0,!0):ir(M,!0,!1))}function ah(_,M,R,L,z,Z,oe,de,ye){if(Ds==null&&Jo(!1),Je(_),_!=null)R=_.clientX-Ds.left,L=_.clientY-Ds.top;else{if(R<0||L<0){Vt=-10,Yt=-10;return}let[Ne,De]=pn.scales,Fe=M.cursor.sync,[nt,bt]=Fe.values,[St,dt]=Fe.scales,[Ze,We]=pn.match,Ht=M.axes[0].side%2==1,tn=I.ori==0?F:Re,Rn=I.ori==1?F:Re,Lt=Ht?Z:z,nn=Ht?z:Z,ri=Ht?L:R,Xn=Ht?R:L;if(St!=null?R=Ze(Ne,St)?a(nt,b[Ne],tn,0):-10:R=tn*(ri/Lt),dt!=null?L=We(De,dt)?a(bt,b[De],Rn,0):-10:L=Rn*(Xn/nn),I.ori==1){let _i=R;R=L,L=_i}}ye&&(M==null||M.cursor.event.type==hd)&&((R<=1||R>=F-1)&&(R=Ar(R,F)),(L<=1||L>=Re-1)&&(L=Ar(L,Re))),de?(Qd=R,ep=L,[Br,kr]=ue.move(i,R,L)):(Vt=R,Yt=L)}let lh={width:0,height:0,left:0,top:0};function ch(){xl(lh,!1)}let op,ap,lp,cp;function up(_,M,R,L,z,Z,oe){Is=!0,An=En=Ln._x=Ln._y=!1,ah(_,M,R,L,z,Z,oe,!0,!1),_!=null&&(vt(fd,_d,hp,!1),Ko(E_,i,Br,kr,F,Re,null));let{left:de,top:ye,width:Ne,height:De}=Gt;op=de,ap=ye,lp=Ne,cp=De}function hp(_,M,R,L,z,Z,oe){Is=Ln._x=Ln._y=!1,ah(_,M,R,L,z,Z,oe,!1,!0);let{left:de,top:ye,width:Ne,height:De}=Gt,Fe=Ne>0||De>0,nt=op!=de||ap!=ye||lp!=Ne||cp!=De;if(Fe&&nt&&xl(Gt),Ln.setScale&&Fe&&nt){let bt=de,St=Ne,dt=ye,Ze=De;if(I.ori==1&&(bt=ye,St=De,dt=de,Ze=Ne),An&&Ls(A,qi(bt,A),qi(bt+St,A)),En)for(let We in b){let Ht=b[We];We!=A&&Ht.from==null&&Ht.min!=Ut&&Ls(We,qi(dt+Ze,We),qi(dt,We))}ch()}else ue.lock&&(ue._lock=!ue._lock,ir(M,!0,_!=null));_!=null&&(vn(fd,_d),Ko(fd,i,Vt,Yt,F,Re,null))}function hy(_,M,R,L,z,Z,oe){if(ue._lock)return;Je(_);let de=Is;if(Is){let ye=!0,Ne=!0,De=10,Fe,nt;I.ori==0?(Fe=An,nt=En):(Fe=En,nt=An),Fe&&nt&&(ye=Vt<=De||Vt>=F-De,Ne=Yt<=De||Yt>=Re-De),Fe&&ye&&(Vt=Vt<Br?0:F),nt&&Ne&&(Yt=Yt<kr?0:Re),ir(null,!0,!0),Is=!1}Vt=-10,Yt=-10,ie.fill(null),ir(null,!0,!0),de&&(Is=de)}function fp(_,M,R,L,z,Z,oe){ue._lock||(Je(_),$o(),ch(),_!=null&&Ko(P_,i,Vt,Yt,F,Re,null))}function dp(){C.forEach(kE),U(i.width,i.height,!0)}Rr(zu,Lo,dp);let Gr={};Gr.mousedown=up,Gr.mousemove=rp,Gr.mouseup=hp,Gr.dblclick=fp,Gr.setSeries=(_,M,R,L)=>{let z=pn.match[2];R=z(i,M,R),R!=-1&&Xi(R,L,!0,!1)},me&&(vt(E_,g,up),vt(hd,g,rp),vt(C_,g,_=>{Je(_),Jo(!1)}),vt(R_,g,hy),vt(P_,g,fp),Td.add(i),i.syncRect=Jo);let vl=i.hooks=n.hooks||{};function Cn(_,M,R){Wn?Pt.push([_,M,R]):_ in vl&&vl[_].forEach(L=>{L.call(null,i,M,R)})}(n.plugins||[]).forEach(_=>{for(let M in _.hooks)vl[M]=(vl[M]||[]).concat(_.hooks[M])});let pp=(_,M,R)=>R,pn=xn({key:null,setSeries:!1,filters:{pub:V_,sub:V_},scales:[A,y[1]?y[1].scale:null],match:[G_,G_,pp],values:[null,null]},ue.sync);pn.match.length==2&&pn.match.push(pp),ue.sync=pn;let mp=pn.key,uh=Bx(mp);function Ko(_,M,R,L,z,Z,oe){pn.filters.pub(_,M,R,L,z,Z,oe)&&uh.pub(_,M,R,L,z,Z,oe)}uh.sub(i);function fy(_,M,R,L,z,Z,oe){pn.filters.sub(_,M,R,L,z,Z,oe)&&Gr[_](null,M,R,L,z,Z,oe)}i.pub=fy;function dy(){uh.unsub(i),Td.delete(i),Tn.clear(),yd(zu,Lo,dp),c.remove(),Ee?.remove(),Cn("destroy")}i.destroy=dy;function hh(){Cn("init",n,e),qo(e||n.data,!1),H[A]?ih(A,H[A]):$o(),ne=Gt.show&&(Gt.width>0||Gt.height>0),ee=pe=!0,U(n.width,n.height)}return y.forEach(Lr),C.forEach(os),t?t instanceof HTMLElement?(t.appendChild(c),hh()):t(i,hh):hh(),i}Fn.assign=xn;Fn.fmtNum=Ld;Fn.rangeNum=Vu;Fn.rangeLog=Wu;Fn.rangeAsinh=Pd;Fn.orient=Ir;Fn.pxRatio=wt;Fn.join=PA;Fn.fmtDate=Dd,Fn.tzDate=VA;Fn.sync=Bx;{Fn.addGap=bE,Fn.clipGaps=$u;let n=Fn.paths={points:Wx};n.linear=qx,n.stepped=AE,n.bars=EE,n.spline=RE}function Vd(n,e=10,t=2500){return{step:e/t,bins:t,used:0,last:-1,base:null,times:new Float64Array(t),values:Object.fromEntries(n.map(s=>[s,new Float64Array(t).fill(NaN)]))}}function Ku(n){n.used=0,n.last=-1,n.base=null}function Gd(n,e,t){if(!Number.isFinite(e))return;n.base===null&&(n.base=e);let i=Math.floor((e-n.base)/n.step);if(i<n.last&&(Ku(n),n.base=e,i=0),i!==n.last){n.used===n.bins&&zE(n),n.times[n.used]=e;for(let o of Object.values(n.values))o[n.used]=NaN;n.used+=1,n.last=i}let r=n.used-1;for(let[o,a]of Object.entries(t)){let l=n.values[o];!l||!Number.isFinite(a)||Math.abs(l[r])>=Math.abs(a)||(l[r]=a)}}function zE(n){let e=n.bins>>3;n.times.copyWithin(0,e);for(let t of Object.values(n.values))t.copyWithin(0,e);n.used-=e}function Hd(n,e){return[n.times.subarray(0,n.used),...e.map(t=>{let i=new Array(n.used);for(let s=0;s<n.used;s++)i[s]=Number.isNaN(n.values[t][s])?null:n.values[t][s];return i})]}function Jx(n,e){let t=Object.keys(e),i=[["time [s]",...t.map(s=>e[s])].join(",")];for(let s=0;s<n.used;s++){let r=t.map(o=>Number.isFinite(n.values[o][s])?n.values[o][s]:"");i.push([n.times[s].toFixed(4),...r].join(","))}return i.join(`
`)+`
`}var zo=10,Wd=56,VE=45,jx=["force","force_x","force_y","force_z","torque","torque_x","torque_y","torque_z","penetration","stretch","energy","model_age","step_cpu","wake_late"],GE=["haptic_rate","contact_rate"],Kx=["x","y","z"],HE=[{id:"force",title:"Force on the hand",unit:"N",least:.001,lines:["force","force_x","force_y","force_z"],names:["size",...Kx],colours:["force","x","y","z"]},{id:"torque",title:"Torque on the hand",unit:"N m",least:1e-6,lines:["torque","torque_x","torque_y","torque_z"],names:["size",...Kx],colours:["torque","x","y","z"]},{id:"penetration",title:"Penetration, below 0: gap",unit:"m",least:1e-9,lines:["penetration"],names:["depth"],colours:["contact"]},{id:"stretch",title:"Coupling stretch",unit:"m",least:1e-9,lines:["stretch"],names:["stretch"],colours:["hand"]},{id:"rates",title:"Contact and haptic rate",unit:"Hz",least:1,lines:["contact_rate","haptic_rate"],names:["contact","haptic"],colours:["contact","held"],slow:!0},{id:"age",title:"Age of the contact model",unit:"s",least:1e-6,lines:["model_age"],names:["age"],colours:["muted"]},{id:"energy",title:"Energy put in by the hand",unit:"J",least:1e-9,lines:["energy"],names:["energy"],colours:["torque"]}];function Qx(n,e,t){let i={pick:t,pointed:null,parent:n,fast:Vd(jx,zo),slow:Vd(GE,zo,600),plots:[],rows:0,now:0,marks:[],theme:null,floors:{Hz:1e3,s:.001},rested:0},s=Object.assign(document.createElement("div"),{className:"plots-head"});i.moment=Object.assign(document.createElement("span"),{className:"grow moment"}),s.append(i.moment);for(let[r,o,a]of e){let l=Object.assign(document.createElement("button"),{type:"button",textContent:r,title:o});l.setAttribute("aria-label",`${r}: ${o}`),l.addEventListener("click",a),s.append(l)}n.append(s),n.addEventListener("keydown",r=>ZE(i,r));for(let r of HE){let o=document.createElement("figure");o.className="plot";let a=document.createElement("figcaption"),l=document.createElement("output"),c=document.createElement("span");c.className="keys",a.append(Object.assign(document.createElement("span"),{textContent:r.title,className:"plot-title"}),c,l);let u=document.createElement("div");u.className="plot-area",o.append(a,u),n.append(o),i.plots.push({spec:r,box:o,area:u,keys:c,value:l,chart:null})}return i}function ju(n){n.theme=Mu();for(let e of n.plots){e.chart?.destroy(),e.keys.replaceChildren(...e.spec.lines.length>1?e.spec.names.map((i,s)=>{let r=Object.assign(document.createElement("i"),{textContent:i});return r.style.setProperty("--tone",Nt(e.spec.colours[s])),r}):[]);let t=e.area.clientWidth||300;e.chart=new Fn(WE(n,e,t),Hd(ev(n,e),e.spec.lines),e.area),e.chart.over.addEventListener("click",()=>{n.pointed&&n.pick(n.pointed.time)})}}var ev=(n,{spec:e})=>e.slow?n.slow:n.fast;function WE(n,{spec:e},t){let i={stroke:Nt("grid"),width:1};return{width:t,height:Wd,legend:{show:!1},cursor:{sync:{key:"thigma"},points:{size:5},drag:{x:!1,y:!1}},padding:[6,6,0,0],scales:{x:{time:!1,range:()=>[n.now-zo,n.now]},y:{range:(r,o,a)=>XE(o,a,Math.max(e.least,n.floors[e.unit]??0))}},axes:[{show:!0,size:4,grid:i,ticks:{show:!1},values:()=>[],space:40},{size:52,grid:i,ticks:{show:!1},space:12,gap:4,font:"10px system-ui, sans-serif",stroke:Nt("muted"),values:(r,o)=>qE(o,e)}],series:[{},...e.lines.map((r,o)=>({stroke:Nt(e.colours[o]),width:o===0||e.slow?1.6:.8,alpha:o===0||e.slow?1:.75,points:{show:!1},spanGaps:!1,fill:o===0&&!e.slow?`${Nt(e.colours[o])}1f`:void 0}))],hooks:{draw:[r=>$E(r,n)]}}}function XE(n,e,t){if(!Number.isFinite(n)||!Number.isFinite(e))return[0,t];let i=Math.min(0,n),s=Math.max(0,e,i+t),r=.1*(s-i);return[i<0?i-r:0,s+r]}function qE(n,e){let t=Math.max(...n.map(Math.abs)),{number:i,unit:s}=Lf(t,e.unit,e.least),r=t===0?1:Number(i)/t,o=n.length>3?2:1,a=n.length-1-(n.length-1)%o;return n.map((l,c)=>{if(c%o!==0)return null;let u=Number((l*r).toPrecision(2)).toString();return c===a?`${u} ${s}`:u})}function $E(n,e){let{ctx:t,bbox:i}=n;t.save(),t.lineWidth=1,t.setLineDash([3,3]);for(let{time:s,kind:r}of e.marks){if(s<e.now-zo)continue;let o=n.valToPos(s,"x",!0);t.strokeStyle=Nt(r==="fault"?"bad":"mark"),t.beginPath(),t.moveTo(o,i.top),t.lineTo(o,i.top+i.height),t.stroke()}t.restore()}function tv(n,e,t){n.marks.push({time:e,kind:t}),n.marks=n.marks.filter(i=>i.time>e-zo).slice(-40)}function nv(n,e,t,i){let s=e/i/10;Object.assign(n.floors,{N:s,"N m":.3*s*e,m:.25*t,J:.01*s*e})}function iv(n,e,t){let i=Object.fromEntries(t.map((r,o)=>[r,o])),s=jx.filter(r=>i[r]!==void 0);for(let r=0;r<e.rows;r++){let o=c=>e.values[r*e.columns+i[c]],a=Object.fromEntries(s.map(c=>[c,o(c)]));a.force=Math.hypot(a.force_x,a.force_y,a.force_z),a.torque=Math.hypot(a.torque_x,a.torque_y,a.torque_z);let l=e.time+o("t");Gd(n.fast,l,a)}n.rows+=e.rows}function sv(n,e,t,i){Gd(n.slow,e,{haptic_rate:t,contact_rate:i})}function rv(n){Ku(n.fast),Ku(n.slow),n.marks=[]}var YE=1/40;function ZE(n,e){let t={ArrowLeft:-1,ArrowRight:1}[e.key];if(!(!t&&e.key!=="Escape"&&e.key!=="Enter"||e.target!==n.parent)){if(e.key==="Enter"){n.pointed&&n.pick(n.pointed.time);return}e.preventDefault();for(let{chart:i}of n.plots){let s=i.over.clientWidth,r=i.cursor.left>=0?i.cursor.left:s,o=t?Math.max(0,Math.min(s-1,r+t*YE*s)):-10;i.setCursor({left:o,top:o<0?-10:.5*Wd},!1,!1)}n.rested=0}}function JE(n){let{chart:e}=n.plots[0],{idx:t,left:i}=e.cursor;if(t==null||!(i>=0)||!(t<n.fast.used))return null;let s=r=>n.fast.values[r][t];return{time:n.fast.times[t],force:s("force"),torque:s("torque"),penetration:s("penetration"),stretch:s("stretch")}}function ov(n,e){let t=performance.now();if(t<n.rested||n.parent.hidden||n.parent.offsetParent===null)return;Object.assign(n,{now:e,pointed:JE(n)});let i=n.pointed?`At ${n.pointed.time.toFixed(2)} s, ${(e-n.pointed.time).toFixed(2)} s ago`:`The last ${zo} s; point at a time to read it`;n.moment.textContent!==i&&(n.moment.textContent=i),n.theme!==Mu()&&ju(n);for(let r of n.plots){let o=Hd(ev(n,r),r.spec.lines),a=r.area.clientWidth;a>0&&a!==r.chart.width&&r.chart.setSize({width:a,height:Wd}),r.chart.setData(o);let l=KE(n,r,o);r.value.textContent=Gn(l(0),r.spec.unit,r.spec.least),[...r.keys.children].forEach((c,u)=>{let h=n.pointed?`${r.spec.names[u]} ${Gn(l(u),r.spec.unit,r.spec.least)}`:r.spec.names[u];c.textContent!==h&&(c.textContent=h)})}let s=performance.now();n.rested=s+Math.max(VE,9*(s-t))}function KE(n,{chart:e},t){let i=e.cursor.left>=0?e.cursor.idx:null;if(i==null)for(i=t[0].length-1;i>0&&t[0][i]>n.now;)i-=1;return s=>i>=0?t[1+s][i]??NaN:NaN}function av(n,e){let t=devicePixelRatio||1,i=n.plots.map(({spec:u,chart:h})=>({spec:u,canvas:h.root.querySelector("canvas")})),s=i[0].canvas.width,r=Math.round(22*t),o=Math.round(34*t),a=document.createElement("canvas");a.width=s,a.height=o+i.reduce((u,{canvas:h})=>u+r+h.height,0)+r;let l=a.getContext("2d");l.fillStyle=Nt("panel"),l.fillRect(0,0,a.width,a.height),l.fillStyle=Nt("ink"),l.font=`600 ${14*t}px system-ui, sans-serif`,l.fillText(e,10*t,22*t);let c=o;l.font=`${12*t}px system-ui, sans-serif`;for(let{spec:u,canvas:h}of i)l.fillText(u.title,10*t,c+15*t),l.drawImage(h,0,c+r),c+=r+h.height;return a}function lv(n){return Jx(n.fast,{force_x:"force x on the hand [N]",force_y:"force y on the hand [N]",force_z:"force z on the hand [N]",torque_x:"torque x on the hand [N m]",torque_y:"torque y on the hand [N m]",torque_z:"torque z on the hand [N m]",penetration:"penetration [m]",stretch:"coupling stretch [m]",energy:"energy put in by the hand [J]",model_age:"age of the contact model [s]"})}var Xd=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"],[1e-12,"p"]];function cv(n,e){let t=Number.isFinite(n)&&n>0?n:2,[i,s]=Xd.find(([r])=>t>=2*r)??Xd[Xd.length-1];return{scale:i,unit:s+e,decimals:Math.max(1,2-Math.floor(Math.log10(t/i)))}}function uv(n,{scale:e,decimals:t}){if(n==null||!Number.isFinite(n))return"–";let i=n/e;return i.toFixed(Math.abs(i)<999.95?t:0)}function hv(n,e,{workspace:t,tolerance:i}){let s=u=>e.find(h=>h.name===u)?.value,r=n?.force>0?n.force:3.3,o=n?.torque>0?n.torque:.1,a=r/(t?.force_scale>0?t.force_scale:1),l=s("coupling_stiffness"),c=s("contact_stiffness");return{force:r,torque:o,stretch:l>0?a/l:10*i,penetration:c>0?Math.max(a/c,i):i}}var fv=(n,e)=>Number.isFinite(n)&&e>0?Math.min(1,Math.abs(n)/e):0;var pv=[{id:"force",name:"Force",unit:"N",help:"on the hand, as sent to the device; the bar ends at the limit of device and safety"},{id:"torque",name:"Torque",unit:"N m",help:"on the hand, about the handle; the bar ends at the limit of device and safety"},{id:"penetration",name:"Depth",unit:"m",help:"of the deepest contact: how far the surfaces pass into each other, or the gap between them; forces begin before they touch; the bar ends where the contact gives the largest force, or the tolerance"},{id:"stretch",name:"Stretch",unit:"m",help:"from the hand to where it holds the object: the spring that is felt; the bar ends at the limit of the force"}];function mv(n){let e={parent:n,tiles:{},lines:{}},t=sn("div","tiles");for(let{id:r,name:o,help:a}of pv){let l=sn("div",`tile ${r}`);l.title=a;let c=sn("span","number"),u=sn("span","unit"),h=sn("span","name",o),f=sn("i","gauge"),p=sn("span","limit");l.append(h,c,u,f,p),t.append(l),e.tiles[r]={tile:l,title:h,number:c,unit:u,gauge:f,limit:p}}let i=sn("p","situation"),s=sn("ul","lines");for(let r of["limit","rows","level","loop","contact","energy"]){let o=sn("li",`line ${r}`),a=sn("i","dot"),l=sn("span");o.append(a,l),s.append(o),e.lines[r]={line:o,text:l,dot:a}}return n.append(t,i,s),e.said=i,e}function sn(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}var dl=n=>Math.hypot(...n);function jE(n,e,t){for(let{id:i,unit:s}of pv){let r=n.tiles[i],o=cv(t[i],s),a=fv(e[i],t[i]);Qu(r.number,uv(i==="penetration"?Math.abs(e[i]):e[i],o)),Qu(r.unit,o.unit),Qu(r.limit,`of ${Number((t[i]/o.scale).toPrecision(2))}`),r.gauge.style.setProperty("--share",a.toFixed(3)),r.tile.classList.toggle("full",a>.9)}Qu(n.tiles.penetration.title,e.penetration<0?"Gap":"Depth")}function Qu(n,e){n.textContent!==e&&(n.textContent=e)}function gv(n,e,t,i,s,r=null){if(!e||!i)return;let o=e.penetration>0;jE(n,r??{force:dl(e.force),torque:dl(e.torque),stretch:e.stretch,penetration:e.penetration},hv(t?.limits,s,i)),n.parent.classList.toggle("pointed",!!r);let a=o||dl(e.contactForce)>0,l={object:i.object.name,statics:i.statics.map(u=>u.name),grasped:(e.bits&1)!==0,armed:(e.bits&6)===2,contacts:e.contactsFound,clusters:e.clusters.length,touching:a},c=(e.bits&yr.constrained)!==0;n.said.textContent=c?QE(n,l,{snapshot:e,state:t,scene:i,parameters:s}):xg(l);for(let u of["limit","rows"])n.lines[u].line.hidden=!c;tC(n.lines.level,e,i),nC(n.lines.loop,e,t,i),iC(n.lines.contact,e,t),Ti(n.lines.energy,"",`The hand has put in ${Gn(e.energy,"J",1e-9)}.`)}function QE(n,e,{snapshot:t,state:i,scene:s,parameters:r}){let o=t.rows.filter(({presses:u})=>u).length,a=r.find(({name:u})=>u==="coupling_stiffness")?.value??null,l=i?.constraint??null,c={pressing:o,stiffness:a,stretch:t.stretch,force:dl(t.force)/s.workspace.force_scale,heldBack:l?.held_back??0,squeezed:l?.squeezed??0,say:Gn};return Ti(n.lines.limit,c.heldBack>.01||c.squeezed>.1?"warn":"good",yg(c)),Ti(n.lines.rows,l?.left_out>0||l?.halvings>0?"warn":"",eC(t,l)),vg({...e,rows:l?.rows??t.rows.length,pressing:o,newtons:Gn(dl(t.force),"N",.001),stiffness:a===null?null:Gn(a,"N/m",1)})}function eC({rows:n},e){if(!e)return"Rows: not counted yet.";let t=[`${ii(e.in_model,"row")} in the contact model`];e.halvings>0&&t.push(`more were needed than fit, so its travel was halved ${e.halvings===1?"once":`${e.halvings} times`}`),e.left_out>0&&t.push(`${ii(e.left_out,"contact")} had no room: nothing may move`),Number.isFinite(e.travel)&&e.travel!==null&&t.push(`free for ${Gn(e.travel,"m",1e-6)} around`);let i=Sg(n);return i>0&&t.push(`${i} at the edge of ${i===1?"its cone":"their cones"}`),`${t.join("; ")}.`}function Ti(n,e,t){n.line.dataset.mood=e,n.text.textContent!==t&&(n.text.textContent=t)}function tC(n,e,t){let i=Df(e.contacts),s=t.object.levels>1?` of ${t.object.levels} levels`:"",r="Level of detail: none in use, as nothing is near.",o=i[0]?.[0]===0?", the original surface":"";i.length===1&&(r=`Level of detail at the contacts: ${i[0][0]}${s}${o}.`),i.length>1&&(r=`Levels of detail at the contacts: ${i.map(([l])=>l).join(", ")}${s}; 0 is the finest.`);let a=Mg(e.contacts);Ti(n,"",a?`${r} Decided ${a}${a.includes("100 %")?"":"; there is nothing finer elsewhere"}.`:r),n.dot.style.background=i.length>0?br(i[0][0]):""}function nC(n,e,t,i){let s=e.hapticRate,r=i.rate;if(t?.replay)return Ti(n,"",`A recording of a loop at ${Math.round(r)} Hz.`);if(!Number.isFinite(s))return Ti(n,"","Haptic loop: not measured yet.");if(t?.run!=="running")return Ti(n,"",`Haptic loop: ${t?.run??"unknown"}.`);let o=s>=.99*r,a=t?.timing?.missed??null,l=a===null?"":`, ${ii(a,"frame")} missed`;return o?Ti(n,"good",`The loop holds ${Math.round(r)} Hz${l}.`):Ti(n,"warn",`The loop runs at ${Math.round(s)} of ${Math.round(r)} Hz${l}.`)}function iC(n,e,t){if(t?.replay){let a=Number.isFinite(e.modelAge)?` The model was ${Gn(e.modelAge,"s",1e-6)} old.`:"";return Ti(n,"",`Contacts are found again where the object was.${a}`)}if(!Number.isFinite(e.contactRate))return Ti(n,"","Contacts: not measured yet.");let i=Number.isFinite(e.modelAge)?`; the model is ${Gn(e.modelAge,"s",1e-6)} old`:"",r=t?.run==="running"?e.modelWeight>.99?"good":"warn":"",o=e.contactsDropped>0?`; ${e.contactsDropped} did not fit`:"";return Ti(n,r,`Contacts found ${Zs(e.contactRate)} times a second, ${Gn(e.queryCpu,"s",1e-6)} each${i}${o}.`)}var dv=[["object","the object"],["hand","where the hand holds it"],["coupling","coupling"],["near","rows near"],["press","rows that press"],["cone","friction cone"]];function _v(n,e){let t=!!e&&(e.bits&yr.constrained)!==0;if(n.hidden=!t,document.body.classList.toggle("constrained",t),!t)return;n.childElementCount===0&&n.replaceChildren(...dv.map(([o,a])=>{let l=sn("span",`swatch row-key ${o}`);return l.append(sn("i"),sn("b","",a),sn("em")),l}));let i=e.rows.filter(({presses:o})=>o),s=(e.bits&1)!==0,r={object:null,hand:s?null:0,coupling:s?null:0,near:e.rows.length-i.length,press:i.length,cone:i.filter(({friction:o})=>o>0).length};dv.forEach(([o],a)=>{let l=n.children[a];l.classList.toggle("active",r[o]!==0);let c=r[o]?`×${r[o]}`:"";l.lastChild.textContent!==c&&(l.lastChild.textContent=c)})}function xv(n,e,t,i=""){let s=Math.min(ws.length,Math.max(t?.object.levels??1,1));if(n.childElementCount!==s+2){let a=Array.from({length:s},(l,c)=>{let u=sn("span","swatch",""),h=c===s-1&&t?.object.levels>s?"+":"";return u.append(sn("i"),sn("b","",`${c}${h}`),sn("em")),u.firstChild.style.background=br(c),u});n.replaceChildren(sn("span","legend-title","Level at contacts"),...a,sn("span","legend-browsed"))}let r=new Map;for(let[a,l]of Df(e?.contacts??[])){let c=Math.min(a,ws.length-1);r.set(c,(r.get(c)??0)+l)}let o=i?`Patches of ${i}`:"";n.lastChild.textContent!==o&&(n.lastChild.textContent=o),[...n.children].slice(1,-1).forEach((a,l)=>{let c=r.get(l)??0;a.classList.toggle("active",c>0);let u=c>0?`×${c}`:"";a.lastChild.textContent!==u&&(a.lastChild.textContent=u)})}function rs(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}function yv(n,e){let t=rs("p","note","Choose a level to see its convex patches, each in a colour of its own. What contacts use at this moment stands in the colours of the legend."),i=rs("div");return n.append(t,i),{list:i,browse:e,rows:[],scene:null}}function Sv(n,e){n.scene=e;let t=[e.object,...e.statics];n.rows=t.map((i,s)=>sC(n,i,s)),n.list.replaceChildren(...n.rows.map(i=>i.box))}function sC(n,e,t){let i=rs("section","level-row"),s=rs("div","level-head"),r=rs("i",t===0?"held":"fixed");s.append(r,rs("h2","",e.name),rs("span","note",ii(e.levels,"level")));let o=rs("div","chips");o.setAttribute("role","radiogroup"),o.setAttribute("aria-label",`Level of the ${e.name}`);let a=rs("p","note"),l={box:i,about:e,body:t,caption:a,chips:[],level:null},c=[null,...(e.level_list??[]).keys()];for(let u of c){let h=Object.assign(rs("button","chip-button",u===null?"as it is":String(u)),{type:"button"});h.setAttribute("role","radio"),h.setAttribute("aria-label",u===null?`${e.name} as it is`:`${e.name}, level ${u}`),u!==null&&u>0&&e.level_list[u].free&&h.classList.add("free"),h.addEventListener("click",()=>vv(n,l,u)),l.chips.push({chip:h,level:u}),o.append(h)}return i.append(s,o,a),vv(n,l,null),l}function vv(n,e,t){let i=e.level!==t;e.level=t;for(let{chip:s,level:r}of e.chips)s.setAttribute("aria-checked",String(r===t));e.caption.textContent=rC(e.about,t),i&&n.browse(e.body,t)}function rC(n,e){if(e===null)return"";let t=n.level_list[e];return e===0?`The original surface: ${ii(t.triangles,"triangle")} in ${ii(t.patches,"convex patch","convex patches")}.`:Cu({about:n},e)?`${ii(t.triangles,"triangle")} in ${ii(t.patches,"convex patch","convex patches")}; nowhere more than ${Gn(t.deviation,"m",1e-9)} off the original.`:`${ii(t.patches,"group")} of patches below, merged pairwise. No surface of its own: contacts here are with convex hulls.`}function Mv(n){return n.rows.filter(e=>e.level!==null).map(e=>`${e.about.name} ${e.level}`).join(", ")}var bv={ball_joint:"Turn the ball in its socket: it has half a millimetre of play.",block_on_gear:"Drag the block over the gear: ridges catch ridges.",blocks:"Turn the upper block about the vertical: its stripes climb out of the others.",conforming:"Press the waves together and turn: everything touches at once.",cup_spoon:"Lead the spoon through the handle of the cup.",ellipsoid:"Roll the ellipsoid over the ball; its tip and its flank feel different.",file_on_cad:"Scrape the file over the flange: rough on rough.",golf:"Tap the ball, then slide the club over its dimples.",hammer_on_torus:"Stroke the ring with the hammer, along and across its ridges.",jaws:"Close the bite, then slide the cusps over each other.",plate:"Draw the probe across the ridges, slowly and fast.",simple_cup_spoon:"Lead the spoon through the handle: few triangles, the same way.",spoon_in_cup:"Nobody holds it: watch the spoon fall into the cup."},wv=n=>bv[n]??"",L2=Object.keys(bv);function Zt(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}var Vo=(n,e,t="")=>{let i=Object.assign(Zt("button",t,n),{type:"button"});return i.addEventListener("click",e),i},oC=[["millimetres",.001],["centimetres",.01],["inches",.0254],["metres",1]];function Av(n,{ask:e,send:t,room:i,limit:s}){let r={dialog:n,ask:e,send:t,room:i,limit:s,menu:{scenes:[],recordings:[]},name:"",model:null,busy:null};n.addEventListener("click",o=>{o.target===n&&n.close()});for(let o of["dragenter","dragover"])addEventListener(o,a=>{[...a.dataTransfer?.types??[]].includes("Files")&&(a.preventDefault(),document.body.classList.add("dropping"))});return addEventListener("dragleave",o=>{o.relatedTarget||document.body.classList.remove("dropping")}),addEventListener("drop",o=>{o.preventDefault(),document.body.classList.remove("dropping");let a=o.dataTransfer?.files?.[0];a&&Pv(r,a)}),r}function Ev(n,e){n.menu=e,n.dialog.open&&!n.model&&Rv(n)}function Cv(n,e){n.name=e,n.model=null,Rv(n),n.dialog.open||n.dialog.showModal()}function Rv(n){let{scenes:e,recordings:t}=n.menu,i=a=>{let l=Zt("div","open-list");return l.append(...a.map(({name:c,title:u})=>{let h=Vo("",()=>aC(n,c),"open-item");h.append(Zt("b","",u||c));let f=wv(c)||(u&&u!==c?c:"");return f&&h.append(Zt("span","note",f)),h.setAttribute("aria-current",String(c===n.name)),h})),l},s=Object.assign(Zt("input"),{type:"file",accept:".obj,.stl,.ply,.off,.mcap",id:"mesh-file"});s.addEventListener("change",()=>{s.files[0]&&Pv(n,s.files[0])});let r=Zt("label","drop-zone");r.htmlFor=s.id,r.append(Zt("b","","A mesh or a recording of your own"),Zt("span","note","Drop an OBJ, STL or PLY file, or a recording (.mcap), anywhere on the page, or click to choose one."),s);let o=[Zt("h2","","Open"),r,Zt("h3","","Scenes"),i(e)];t.length>0&&o.push(Zt("h3","","Recordings"),i(t)),n.dialog.replaceChildren(...o,qd(n,[Vo("Cancel",()=>n.dialog.close())]))}function qd(n,e,t=""){let i=Zt("div","dialog-foot"),s=Zt("p","refusal",t);return s.setAttribute("role","alert"),i.append(s,...e),n.said=s,i}async function aC(n,e){(await $d(n,{type:"open",value:e})).ok&&n.dialog.close()}async function $d(n,e){if(n.busy)return{ok:!1};n.dialog.classList.add("busy"),n.busy=n.ask(e);let t=await n.busy;return n.busy=null,n.dialog.classList.remove("busy"),!t.ok&&n.said&&(n.said.textContent=t.reason??"The program refused."),t}async function Pv(n,e){for(;n.busy;)await n.busy;n.model={name:e.name};let t=Object.assign(Zt("progress"),{max:1,value:0});n.dialog.replaceChildren(Zt("h2","",e.name),Zt("p","note","Sending and looking at it …"),t,qd(n,[Vo("Cancel",()=>n.dialog.close())])),n.dialog.open||n.dialog.showModal();let i=new Uint8Array(await e.arrayBuffer()),s=$d(n,{type:"upload",name:e.name.slice(-120),value:i.length});await lC(n,i,t),(await s).ok&&e.name.endsWith(".mcap")&&n.dialog.close()}async function lC(n,e,t){let i=Math.max(1024,Math.min(n.limit(),65536)-64);for(let s=0;s<e.length&&n.busy;){for(let r=0;r<8&&s<e.length&&n.room()<4*i;r++){if(!n.send(Pg(e.subarray(s,s+i))))return;s+=i}t.value=Math.min(1,s/e.length),await new Promise(r=>setTimeout(r,10))}}function Iv(n,e){n.model=e;let{report:t}=e,i=t.verdict==="usable",s=t.verdict==="repairable",r=Zt("p",`verdict ${t.verdict}`,{usable:"Ready to use",repairable:"Needs repair first",rejected:"Cannot be used"}[t.verdict]??t.verdict),o=Zt("p","",`${ii(t.triangles,"triangle")}, ${t.closed?"closed":"open"}, ${ii(t.components,"part")}.`),a=Zt("ul","reasons");for(let v of[...t.reasons,...t.warnings])a.append(Zt("li","",v));let l=Object.assign(Zt("select"),{id:"mesh-unit"}),c=[...oC.map(([v,d])=>[`${v} (${Tv(t,d)})`,d]),[`whatever makes it as large as the object (${Tv(t,e.object_radius/t.radius)})`,e.object_radius/t.radius]];l.append(...c.map(([v,d])=>new Option(v,String(d)))),l.value=String(e.unit);let u=Object.assign(Zt("label","","Its unit is "),{htmlFor:l.id}),h=Zt("p","unit-choice");h.append(u,l);let f=v=>async()=>{(await $d(n,{type:"place",name:v,value:Number(l.value),repair:s})).ok&&n.dialog.close()},p=s?"Repair and ":"",g=[Vo("Cancel",()=>n.dialog.close())];(i||s)&&g.push(Vo(p?"Repair and touch it":"Touch it",f("touch")),Vo(p?"Repair and hold it":"Hold it",f("hold"),"primary")),n.dialog.replaceChildren(Zt("h2","",e.name),r,o,a,...i||s?[h]:[],qd(n,g)),n.dialog.open||n.dialog.showModal()}function Tv(n,e){let t=e*Math.max(...n.bounds.max.map((i,s)=>i-n.bounds.min[s]));return Number.isFinite(t)?t<.9995?`${Zs(1e3*t)} mm`:`${Zs(t)} m`:"–"}var cC=[.05,.1,.25,.5,1,2,4];function Lv(n,e){let t={parent:n,act:e,held:!1,waiting:!1,next:null};t.play=fi("pause","Pause","P",e.pause),t.slider=Object.assign(document.createElement("input"),{type:"range",min:0,max:1,step:"any"}),t.slider.setAttribute("aria-label","Time in the recording"),t.text=document.createElement("output"),t.slider.addEventListener("input",()=>{t.held=!0,Nv(t,Number(t.slider.value))});for(let s of["change","blur"])t.slider.addEventListener(s,()=>{t.held=!1});t.speed=Object.assign(document.createElement("select"),{title:"How fast it is shown"}),t.speed.setAttribute("aria-label",t.speed.title),t.speed.append(...cC.map(s=>new Option(`${s} ×`,String(s)))),t.speed.value="1",t.speed.addEventListener("change",()=>e.speed(Number(t.speed.value))),t.strip=document.createElement("canvas"),t.strip.setAttribute("aria-hidden","true"),t.force=[];let i=Object.assign(document.createElement("div"),{className:"track"});return i.append(t.strip,t.slider),n.append(t.play,i,t.speed,t.text),t}async function Nv(n,e){if(n.waiting){n.next=e;return}n.waiting=!0,await n.act.seek(e),n.waiting=!1;let t=n.next;n.next=null,t!==null&&Nv(n,t)}function Dv(n,{force:e}){n.force=e,n.drawnAt=null}function uC(n){let{clientWidth:e,clientHeight:t}=n.strip,i=Nt("force"),s=`${e} ${t} ${i}`;if(n.drawnAt===s||e===0)return;n.drawnAt=s,Object.assign(n.strip,{width:e,height:t});let r=n.strip.getContext("2d"),o=n.force.reduce((a,l)=>Math.max(a,l??0),0);r.clearRect(0,0,e,t),r.fillStyle=i,n.force.forEach((a,l)=>{let c=o>0?t*(a??0)/o:0;r.fillRect(l*e/n.force.length,t-c,e/n.force.length+.5,c)})}function Uv(n,e,t){let i=e?.replay??null;if(n.parent.hidden=!i,!i)return;let s=n.held||n.waiting?Number(n.slider.value):t?.time??0;n.slider.max=i.seconds,!n.held&&!n.waiting&&(n.slider.value=s),n.slider.setAttribute("aria-valuetext",`${xr(s)} of ${xr(i.seconds)}`),n.text.textContent=`${xr(s)} / ${xr(i.seconds)}`,document.activeElement!==n.speed&&(n.speed.value=String(i.speed??1)),uC(n);let r=e.run==="paused";qa(n.play,r?"play":"pause"),To(n.play,r?"Play":"Hold","P")}var Fv=26,hC=110,Yd=[["1","+x",[1,0,0]],["2","-x",[-1,0,0]],["3","+y",[0,1,0]],["4","-y",[0,-1,0]],["5","+z",[0,0,1]],["6","-z",[0,0,-1]]];function Go(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}function Bv(n,e,t){let i=Go("div","compass"),s=document.createElementNS("http://www.w3.org/2000/svg","svg");i.setAttribute("role","group"),i.setAttribute("aria-label","Views along the axes"),s.setAttribute("viewBox","-36 -36 72 72"),s.setAttribute("aria-hidden","true"),i.append(s);let r=Yd.map(([l,c,u])=>{let h=document.createElementNS("http://www.w3.org/2000/svg","line"),f=Object.assign(Go("button",`axis axis-${c[1]} ${c[0]==="+"?"plus":"minus"}`,c[0]==="+"?c[1]:""),{type:"button",title:`View from ${c} (${l})`});return f.setAttribute("aria-label",`View from ${c}`),f.addEventListener("click",()=>t(u)),h.classList.add(`axis-${c[1]}`),c[0]==="+"&&s.append(h),i.append(f),{way:new W(...u),line:h,button:f}}),o=l=>{let c=Go("div",`ruler ${l}`),u=Go("span"),h=Go("i");return c.append(u,h),{box:c,text:u,length:h}},a={parent:n,names:e,ends:r,scale:o("ruler-scale"),force:o("ruler-force"),tags:[]};return n.replaceChildren(a.force.box,a.scale.box,i),a}function kv(n,e,t){let{view:i,options:s,canvas:r}=e;if(!e.object||r.clientHeight===0)return;let{right:o,up:a,forward:l}=_r(i);for(let{way:f,line:p,button:g}of n.ends){let v=Fv*f.dot(o),d=-Fv*f.dot(a);p.setAttribute("x2",v.toFixed(1)),p.setAttribute("y2",d.toFixed(1)),g.style.transform=`translate(${v.toFixed(1)}px, ${d.toFixed(1)}px)`,g.style.zIndex=f.dot(l)<0?2:1}let c=e.root.localToWorld(e.object.group.position.clone()),u=Wa(i,Xa(i,c),r.clientHeight)*e.radius;Ov(n.scale,u,"m",1e-9);let h=t?.metresPerNewton;n.force.box.hidden=!(h>0)||!s.forces,h>0&&Ov(n.force,u/(ad*h),"N",1e-6),fC(n,e,a)}function Ov({text:n,length:e},t,i,s){let r=Og(hC*t),o=Gn(r,i,s).replace(/\.0+(?= )/,"");n.textContent!==o&&(n.textContent=o),e.style.width=`${(r/t).toFixed(1)}px`}function fC(n,e,t){let{options:i,view:s,canvas:r}=e,o=Mi(e);if(n.names.hidden=!i.names,!i.names)return;(n.tags.length!==o.length||n.tags.some(({textContent:l},c)=>l!==o[c].about.name))&&(n.tags=o.map(({about:l},c)=>Go("span",`name-tag ${c===0?"held":"fixed"}`,l.name)),n.names.replaceChildren(...n.tags));let a=new W;o.forEach(({about:l,group:c},u)=>{e.root.localToWorld(a.set(...l.center).applyQuaternion(c.quaternion).add(c.position)),a.addScaledVector(t,(u===0?.8:-.8)*l.radius/e.radius).project(s.camera);let h=(a.x+1)/2*r.clientWidth,f=(1-a.y)/2*r.clientHeight,p=a.z<1&&h>0&&h<r.clientWidth&&f>0&&f<r.clientHeight;n.tags[u].style.visibility=p?"":"hidden",n.tags[u].style.transform=`translate(${h.toFixed(0)}px, ${f.toFixed(0)}px) translate(-50%, -50%)`})}function dC(n,e,t){let i=e?[e,...n]:n,s=i[0]?.time??0,r=(i.at(-1)?.time??0)-s;if(!(r>0)||r>1||!(t>0))return{samples:new Float32Array(0),last:i.at(-1)??null};let o=new Float32Array(Math.floor(r*8e3)),a=1;for(let l=0;l<o.length;l++){let c=s+l/8e3;for(;a<i.length-1&&i[a].time<c;)a+=1;let u=(i[a].force-i[a-1].force)/t;o[l]=Number.isFinite(u)?Math.tanh(12*u):0}return{samples:o,last:i.at(-1)}}var zv=()=>({context:null,on:!1,last:null,until:0,played:0});function Vv(n){return n.on=!n.on,n.last=null,n.on?(n.context??=new AudioContext,n.context.resume()):n.context?.suspend(),n.on}function Gv(n,e,t,i){if(!n.on||!n.context)return;let s=Array.from({length:e.rows},(h,f)=>{let p=g=>e.values[f*e.columns+t[g]];return{time:e.time+p("t"),force:Math.hypot(p("force_x"),p("force_y"),p("force_z"))}}),{samples:r,last:o}=dC(s,n.last,i);if(n.last=o,r.length===0)return;let{context:a}=n,l=a.createBuffer(1,r.length,8e3);l.copyToChannel(r,0);let c=new AudioBufferSourceNode(a,{buffer:l});c.connect(a.destination);let u=a.currentTime;(n.until<u||n.until>u+3*.08)&&(n.until=u+.08),c.start(n.until),n.until+=r.length/8e3,n.played+=1}function Hv(n,e){let t=e.map(([s,r])=>{let o=Object.assign(document.createElement("button"),{type:"button",textContent:r});return o.setAttribute("role","tab"),o.setAttribute("aria-controls",s),o.addEventListener("click",()=>i(s)),{id:s,tab:o}});function i(s){for(let{id:r,tab:o}of t)o.setAttribute("aria-selected",String(r===s)),o.tabIndex=r===s?0:-1,document.getElementById(r).hidden=r!==s}return n.addEventListener("keydown",({key:s})=>{let r={ArrowRight:1,ArrowLeft:-1}[s],o=t.findIndex(({tab:l})=>l===document.activeElement);if(!r||o<0)return;let a=t[(o+r+t.length)%t.length];i(a.id),a.tab.focus()}),n.append(...t.map(({tab:s})=>s)),i(e[0][0]),i}var qt=n=>document.getElementById(n),pC=50,he={connected:!1,hello:null,scene:null,meshes:new Map,state:null,parameters:[],snapshot:null,shown:null,refusal:null,counts:{snapshot:0,channels:0,mesh:0,event:0},holding:!1,turned:!1,trouble:null,progress:null,fresh:!1,asking:!1,sent:0,faultName:()=>he.hello?.faults?.[he.snapshot?.fault??0]??"fault"},Qn=Lg(),mC=Ag(),pt=null,gi=null,Ai=Qx(qt("plots"),[["PNG","Save the plots as a picture",()=>av(Ai,AC()).toBlob(n=>Wv(Xv("png"),n))],["CSV","Save the plots as a table",()=>Wv(Xv("csv"),new Blob([lv(Ai)],{type:"text/csv"}))]],n=>he.state?.replay&&rn.seek(n)),gC=mv(qt("readouts")),Kd=zv(),Zv=yv(qt("levels"),(n,e)=>pt&&Mi(pt)[n]&&t_(pt,Mi(pt)[n],e)),Jd=Av(qt("opener"),{ask:n=>Tr(gi,n),send:n=>p_(gi,n),room:()=>m_(gi),limit:()=>he.hello?.max_message??4096}),_C=v_(qt("parameters"),(n,e)=>Tr(gi,{type:"set",name:n,value:e}));async function Cs(n){let e=await Tr(gi,n);return e.ok||(he.refusal={text:e.reason??"The program refused.",until:performance.now()/1e3+6}),e}var rn={open:()=>qt("opener").open?qt("opener").close():Cv(Jd,he.scene?.name??""),seek:n=>Cs({type:"seek",value:n}),pause:()=>Cs({type:"pause",value:he.state?.run!=="paused"}),step:()=>Cs({type:"step",value:1}),reset:()=>Cs({type:"reset"}),record:()=>Cs({type:"record",value:!he.state?.recording}),device:n=>Cs({type:"use_device",value:n}).then(e=>ml(e.ok&&n.startsWith("web:"))),help:()=>qt("help").open?qt("help").close():xC(),theme:()=>yC(),view:n=>{pt&&(n_(pt,{[n]:!pt.options[n]}),Ff(eh,pt.options))},fit:()=>pt&&gu(pt.view),speed:n=>Cs({type:"speed",value:n}),sound:()=>Uf(eh,Vv(Kd)),look:n=>pt&&mg(pt.view,n),zoom:n=>pt&&wo(pt.view,n)};function xC(){qt("help").showModal(),qt("help").scrollTop=0}var eh=bg(rn),vC=Bv(qt("rulers"),qt("names"),rn.look),Jv=Lv(qt("replay"),rn),yC=Xg(()=>{pt&&Nu(pt),ju(Ai)}),SC={hello:n=>{he.hello=n},scene:n=>{let e=n.refined&&he.snapshot!==null;he.scene=n,he.meshes.clear(),Sv(Zv,n),!e&&(he.scene.refined=!1,he.snapshot=he.shown=null,he.fresh=!1,tr("Loading the objects …"))},mesh:n=>{he.counts.mesh+=1,he.meshes.set(n.number,n),[he.scene.object,...he.scene.statics].map(t=>t.mesh).every(t=>he.meshes.has(t))&&(pt&&j0(pt,he.scene,he.meshes,he.scene.refined),he.scene.refined||tr(he.trouble))},level:n=>{pt&&Q0(pt,n)},relief:n=>{pt&&e_(pt,n)},strip:n=>Dv(Jv,n),menu:n=>Ev(Jd,n),model:n=>Iv(Jd,n),progress:({what:n,share:e})=>{he.progress=n,n?(qt("opener").close(),tr(`${n[0].toUpperCase()}${n.slice(1)} …`,e,()=>Cs({type:"cancel"}))):tr(he.trouble)},parameters:n=>{he.parameters=n.list,y_(_C,n.list)},state:n=>{he.state&&he.state.session!==n.session&&MC(),he.state=n,ml(n.holder==="you")},event:n=>{he.counts.event+=1,M_(qt("events"),n),tv(Ai,n.time,n.kind),["recording_ended","held_back","squeezed"].includes(n.kind)&&(he.refusal={text:`${vu(n)}.`,until:performance.now()/1e3+10})},channels:n=>{he.counts.channels+=1;let e=["t",...he.hello.channels.map(t=>t.name).filter(t=>t!=="t")];iv(Ai,n,e),Gv(Kd,n,Object.fromEntries(e.map((t,i)=>[t,i])),he.state?.limits?.force??ty())},snapshot:n=>{he.counts.snapshot+=1;let e=n.bits&~(he.snapshot?.bits??0);he.snapshot=n,e&yr.fault&&(Qn.clutch=!1),he.fresh=!0,n.metresPerNewton>0&&nv(Ai,he.scene.object.radius,he.scene.tolerance,n.metresPerNewton),sv(Ai,n.time,n.hapticRate,n.contactRate)}};function MC(){Qn.clutch=!1,rv(Ai),qt("events").replaceChildren()}function tr(n,e=null,t=null){let i=qt("veil");if(i.hidden=!n,i.classList.toggle("working",e!==null),!n){i.replaceChildren();return}if(e!==null&&i.querySelector("progress")){i.querySelector("p").textContent=n,i.querySelector("progress").value=e;return}let s=Object.assign(document.createElement("p"),{textContent:n}),r=Object.assign(document.createElement("progress"),{max:1,value:e??0});r.setAttribute("aria-label","How far it is");let o=Object.assign(document.createElement("button"),{type:"button",className:"primary",textContent:"Cancel"});o.addEventListener("click",t??(()=>{})),i.replaceChildren(s,...e===null?[]:[r],...t?[o]:[])}function bC(n){he.connected=!1,ml(!1),Qn.clutch=!1,Hf(Qn),document.body.classList.add("lost"),he.progress=null,tr(`${n} Nothing is felt or shown any more. ${gi?.stopped?"":"Trying again …"}`)}function wC(){he.connected=!0,document.body.classList.remove("lost"),tr(null)}var Ho={get stage(){return pt},hand:Qn,workspace:()=>he.scene.workspace,grasp:()=>he.snapshot?.grasp??[0,0,0],mayMove:()=>he.connected&&he.hello?.may_control!==!1&&!!he.state?.device.startsWith("web:")&&he.state.holder!=="other"&&he.state.run!=="ended"&&!he.state.replay&&!!he.snapshot,async press(){if(Qn.clutch&&he.holding||he.asking)return;he.asking=!0;let n=Gf(Qn);he.holding||ml((await Cs({type:"hold",value:!0})).ok),he.asking=!1,he.holding&&(Ao(Qn,performance.now()/1e3,n),Qn.clutch=!0,th())},moved:n=>{he.turned||=n},give:Kv,letGo:()=>{Qn.clutch=!1,th()}};function ml(n){he.holding&&!n&&d_(gi),he.holding=n}function Kv(){if(!he.holding||!he.connected)return;let n=Hf(Qn);f_(gi,n),he.sent+=n.length}function th(){he.holding&&(Ao(Qn,performance.now()/1e3),Kv())}function jv(){he.holding&&(Ho.letGo(),ml(!1),Tr(gi,{type:"hold",value:!1}))}document.addEventListener("visibilitychange",()=>{document.hidden&&jv()});addEventListener("pagehide",jv);addEventListener("keydown",n=>{if(n.target.closest?.("input, select, textarea")||n.ctrlKey||n.metaKey||n.altKey)return;let i={" ":()=>Qn.clutch?Ho.letGo():Ho.mayMove()&&Ho.press(),p:rn.pause,".":rn.step,r:rn.reset,f:rn.fit,o:rn.open,"?":rn.help,h:rn.help,l:()=>rn.view("wireframe"),g:()=>rn.view("ghost"),c:()=>rn.view("contacts"),a:()=>rn.view("forces"),n:()=>rn.view("names"),s:rn.sound,"+":()=>rn.zoom(.87),"-":()=>rn.zoom(1.15),...Object.fromEntries(Yd.map(([s,,r])=>[s,()=>rn.look(r)]))}[n.key.length===1?n.key.toLowerCase():""];!i||n.key===" "&&n.target.closest?.("button")||(n.preventDefault(),i())});function TC(){try{pt=K0(qt("scene"),new URLSearchParams(location.search).get("picture"))}catch(n){return he.trouble="This browser shows no WebGL 2, so there is no picture; numbers and plots work. Hardware acceleration may be off in its settings.",tr(he.trouble),console.warn(String(n.message??n)),null}return pt.wants=(n,e)=>Tr(gi,{type:"level",mesh:n,value:e}),Nu(pt),Ff(eh,pt.options),new ResizeObserver(()=>ld(pt)).observe(qt("stage")),ld(pt),a_(Ho)}function Wv(n,e){let t=Object.assign(document.createElement("a"),{href:URL.createObjectURL(e),download:n});t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}var Xv=n=>`thigma-${(he.snapshot?.time??0).toFixed(1)}s.${n}`,pl=TC();b_(qt("help"));var AC=()=>`${he.scene?.title??""}, to ${(he.snapshot?.time??0).toFixed(1)} s`;Hv(qt("tabs"),[["plots","Plots"],["parameters","Parameters"],["levels","Levels"],["events","Events"]]);ju(Ai);tr("Connecting …");var qv=/^#token=([0-9a-f]+)$/.exec(location.hash)?.[1];gi=h_(`${location.protocol==="https:"?"wss":"ws"}://${location.host}/live${qv?`?token=${qv}`:""}`,{message:n=>SC[n.type??n.kind]?.(n),opened:wC,lost:bC});setInterval(th,pC);var Zd=performance.now(),$v=0,Qv=0,Yv=0;function EC(){return pt&&!i_(pt)||(he.fresh&&(he.shown=he.snapshot,pt&&Du(pt,he.shown),he.fresh=!1),!pt||!s_(pt))?!1:(Qv+=1,kv(vC,pt,he.shown),!0)}function ey(n){requestAnimationFrame(ey);let e=he.snapshot?Math.hypot(...he.snapshot.force):0;pl&&u_(pl,(n-Zd)/1e3,e,ty()),pl&&c_(pl,(n-Zd)/1e3),Zd=n,th();let t=EC();$v+=1,ov(Ai,he.shown?.time??0);let i=performance.now();$v%6!==0&&!(t&&i>=Yv)||(CC(n/1e3,e),Yv=10*performance.now()-9*i)}function ty(){let n=he.snapshot?.metresPerNewton;return n>0&&he.scene?he.scene.object.radius/n:3}function CC(n,e){wg(eh,he),gv(gC,he.shown,he.state,he.scene,he.parameters,Ai.pointed),_v(qt("row-legend"),he.shown),xv(qt("legend"),he.shown,he.scene,Mv(Zv)),Uv(Jv,he.state,he.shown),Tg(qt("hint"),Eg(mC,he,{now:n,newtons:e,holding:he.holding&&Qn.clutch,turned:he.turned,touch:pl?.touch??matchMedia("(pointer: coarse)").matches},rn))}requestAnimationFrame(ey);window.thigma={session:he,hand:Qn,plots:Ai,sound:Kd,player:Ho,act:rn,ask:n=>Tr(gi,n),get stage(){return pt},get link(){return gi},get drawn(){return Qv}};})();
